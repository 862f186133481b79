package org.maestro.bench.containers;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.maestro.agents.content.Words;
import org.maestro.bench.BenchReport;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.KnowledgeSettings;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.Home;
import org.maestro.planning.OptimalPlanner;
import org.maestro.platform.MaestroPlatform;
import org.maestro.platform.PlatformServices;
import org.maestro.platform.PlatformSettings;
import org.maestro.platform.failover.OtherNames;
import org.maestro.platform.threads.AgentThreads;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.InProcessBus;

/**
 * Many generic agents in one process: a home of so many devices, each of which gets its agent as in
 * every run, in the container of its topic. First the time until all agents are there and what one
 * takes of the heap, then the devices come to the bus: the time until every agent has read its
 * device's description, the knowledge has it, the yellow pages have its features, and the central
 * agent can use it; and what an agent then takes. At last messages. For one thread.
 */
public final class AgentsBench {
  private static final int PER_HALL = 400;
  private static final int SMALL = 30;
  private static final String NAME = "bench-agents";
  private static final Duration ALL_WITHIN = Duration.ofMinutes(4);
  private static final int MOST_ASKED = 2_000;
  private static final int AT_ONCE = 64;
  private static final double NANOS_IN_MILLI = 1e6;

  private final int agents;
  private final Consumer<String> progress;
  private final List<BenchReport.Row> rows = new ArrayList<>();

  /**
   * @param agents so many
   * @param progress told what is being done
   */
  public AgentsBench(int agents, Consumer<String> progress) {
    this.agents = agents;
    this.progress = progress;
  }

  public BenchReport run() {
    warmUp();
    progress.accept("A home of %d devices is read.".formatted(agents));
    Home home = new CrowdedHome(agents, PER_HALL).home();
    try (PacedClock clock = new PacedClock(1)) {
      InProcessBus bus = new InProcessBus(clock);
      KnowledgeBase knowledge = CollectiveKnowledge.open(home, clock, KnowledgeSettings.inMemory());
      try (RatsLink link = BusLink.connect("maestro", NAME, bus.client("maestro"), clock);
          Crowd crowd = new Crowd(bus.client("crowd"), NAME)) {
        long before = used();
        progress.accept("%d agents are made.".formatted(agents));
        long begin = System.nanoTime();
        try (MaestroPlatform platform = platform(knowledge, link, clock, home)) {
          await("agents in the platform's table", () -> there(platform) == agents);
          row("%d agents made, platform and all".formatted(agents), seconds(begin), "s");
          row("heap of each", kibibytes(before, agents), "KiB");
          messages(platform, home, "");
          progress.accept("%d devices come.".formatted(agents));
          begin = System.nanoTime();
          crowd.come(home);
          await("members in use", () -> platform.presentMembers().size() == agents);
          row("%d devices described and in use".formatted(agents), seconds(begin), "s");
          row(
              "heap of each, described, with all that is known of it",
              kibibytes(before, agents),
              "KiB");
          messages(platform, home, ", described");
        }
      }
    }
    return new BenchReport(
        "agents",
        BenchReport.thisMachine(),
        rows,
        List.of("Agents run on threads: " + AgentThreads.chosen()));
  }

  /** What is loaded and compiled once belongs to no agent. */
  private static void warmUp() {
    Home home = new CrowdedHome(SMALL, PER_HALL).home();
    try (PacedClock clock = new PacedClock(1)) {
      InProcessBus bus = new InProcessBus(clock);
      try (RatsLink link = BusLink.connect("maestro", NAME, bus.client("maestro"), clock);
          Crowd crowd = new Crowd(bus.client("crowd"), NAME);
          MaestroPlatform platform =
              platform(
                  CollectiveKnowledge.open(home, clock, KnowledgeSettings.inMemory()),
                  link,
                  clock,
                  home)) {
        crowd.come(home);
        await("members in use", () -> platform.presentMembers().size() == home.devices().size());
      }
    }
  }

  private static MaestroPlatform platform(
      KnowledgeBase knowledge, RatsLink link, PacedClock clock, Home home) {
    return MaestroPlatform.start(
        PlatformSettings.of(NAME).build(),
        new PlatformServices(
            knowledge,
            new OptimalPlanner(),
            link,
            OtherNames.unrestricted(controller -> link),
            clock,
            DescriptionReader.of(home)::read));
  }

  private static long there(MaestroPlatform platform) {
    return platform.agents().stream()
        .filter(row -> platform.directory().find(row.agent()).isPresent())
        .count();
  }

  private void messages(MaestroPlatform platform, Home home, String which) {
    List<String> names = new ArrayList<>(home.devices().keySet());
    Collections.shuffle(names, new Random(1));
    int asked = Math.min(MOST_ASKED, 2 * names.size());
    for (int i = 0; i < asked; i++) {
      ask(platform, names.get(i % names.size()));
    }
    List<Long> nanos = new ArrayList<>();
    for (int i = 0; i < asked; i++) {
      long begin = System.nanoTime();
      ask(platform, names.get(i * 31 % names.size()));
      nanos.add(System.nanoTime() - begin);
    }
    Collections.sort(nanos);
    row("question and answer" + which + ", p50", nanos.get(asked / 2) / NANOS_IN_MILLI, "ms");
    row(
        "question and answer" + which + ", p99",
        nanos.get(asked * 99 / 100) / NANOS_IN_MILLI,
        "ms");
    Semaphore free = new Semaphore(AT_ONCE);
    long begin = System.nanoTime();
    for (String name : names) {
      acquire(free, 1);
      request(platform, name, free::release);
    }
    acquire(free, AT_ONCE);
    row(
        "every agent asked once, %d at a time%s".formatted(AT_ONCE, which),
        names.size() / seconds(begin),
        "answers/s");
  }

  private static void ask(MaestroPlatform platform, String agent) {
    Semaphore answered = new Semaphore(0);
    request(platform, agent, answered::release);
    acquire(answered, 1);
  }

  /** For the agent's own goals, of which it has none. */
  private static void request(MaestroPlatform platform, String agent, Runnable answered) {
    platform
        .desk()
        .request(
            ACLMessage.QUERY_REF,
            agent,
            Duration.ofSeconds(30),
            reply -> {
              if (reply.getPerformative() != ACLMessage.INFORM) {
                throw new IllegalStateException("The agent " + agent + " said: " + reply);
              }
              answered.run();
            },
            Words.content("query-ref"));
  }

  private static void acquire(Semaphore semaphore, int permits) {
    try {
      if (!semaphore.tryAcquire(permits, 60, TimeUnit.SECONDS)) {
        throw new IllegalStateException("No answer came within 60 s.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("The benchmark was interrupted.", e);
    }
  }

  private static void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + ALL_WITHIN.toNanos();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new IllegalStateException(
            "Not all %s within %d s.".formatted(what, ALL_WITHIN.toSeconds()));
      }
      LockSupport.parkNanos(5_000_000);
    }
  }

  private void row(String name, double value, String unit) {
    progress.accept("%s: %.2f %s".formatted(name, value, unit));
    rows.add(BenchReport.Row.of(name, value, unit));
  }

  private static double seconds(long beginNanos) {
    return (System.nanoTime() - beginNanos) / 1e9;
  }

  private static double kibibytes(long before, int agents) {
    return (used() - before) / 1_024.0 / agents;
  }

  private static long used() {
    Runtime runtime = Runtime.getRuntime();
    long least = Long.MAX_VALUE;
    for (int round = 0; round < 3; round++) {
      System.gc();
      least = Math.min(least, runtime.totalMemory() - runtime.freeMemory());
    }
    return least;
  }
}
