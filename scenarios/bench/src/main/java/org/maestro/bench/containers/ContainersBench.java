package org.maestro.bench.containers;

import java.net.URI;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Queue;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.maestro.agents.content.GoalReport;
import org.maestro.bench.BenchReport;
import org.maestro.bench.Waiting;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.KnowledgeSettings;
import org.maestro.ontology.home.DescriptionReader;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.OptimalPlanner;
import org.maestro.platform.AgentRow;
import org.maestro.platform.MaestroPlatform;
import org.maestro.platform.PlatformServices;
import org.maestro.platform.PlatformSettings;
import org.maestro.platform.failover.OtherNames;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.Admission;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.sl.SlParser;

/**
 * Hundreds of hosts, simulated by processes with several containers each: every container has the
 * agent of a device of its own, over a real broker. While goals are pursued, some at a time, one in
 * ten processes is killed, one after the other. Measured is whether all goals end, and how long
 * they take. For one thread.
 */
public final class ContainersBench {
  private static final int UNDER_WAY = 16;
  private static final int AT_ONCE = 3;
  private static final int TOLD_EACH = 100;
  private static final Duration ALL_WITHIN = Duration.ofSeconds(90);
  private static final Duration GOAL_WITHIN = Duration.ofMinutes(5);
  private static final int KILLED_OF_TEN = 10;
  private static final int RADIX = Character.MAX_RADIX;

  /** How rows of processor time begin; the part follows. */
  static final String PROCESSOR = "processor time of a goal, ";

  private static final String EMPTY_HOME =
      """
      @prefix home: <https://w3id.org/maestro/home/hosts#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      <https://w3id.org/maestro/home/hosts> a maestro:Home ; rdfs:label "many hosts"@en .
      home:hall a maestro:Room ; maestro:outline "0 0, 9 0, 9 9, 0 9" ; maestro:height 2.8 .
      home:zone a maestro:Zone ; maestro:outline "0 0, 9 0, 9 9, 0 9" ;
        maestro:referencePoint "4 4 0" .
      """;

  /** Two platforms of one name in a process get into each other's way, also one after the other. */
  private final String site = "bench-containers-" + Long.toString(System.nanoTime(), RADIX);

  private final int processes;
  private final int containers;
  private final int goals;
  private final Random chance;
  private final Consumer<String> progress;
  private final List<BenchReport.Row> rows = new ArrayList<>();

  /**
   * @param processes from 1; as many as ten killed of a hundred, at least one
   * @param containers in all
   * @param seed of which processes are killed
   * @param progress told what is being done
   */
  public ContainersBench(
      int processes, int containers, int goals, long seed, Consumer<String> progress) {
    this.processes = processes;
    this.containers = containers;
    this.goals = goals;
    this.chance = new Random(seed);
    this.progress = progress;
  }

  public BenchReport run() {
    Waiting.formerPlatformsHaveEnded();
    Home home = new HomeLoader().load(EMPTY_HOME, "hosts.ttl");
    List<HostProcess> hosts = new CopyOnWriteArrayList<>();
    try {
      measure(home, hosts);
    } finally {
      // After the platform, which would begin all their agents again.
      hosts.forEach(HostProcess::close);
    }
    return new BenchReport("containers", BenchReport.thisMachine(), rows);
  }

  private void measure(Home home, List<HostProcess> hosts) {
    List<RatsMember> members = new ArrayList<>();
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        PacedClock clock = new PacedClock(1);
        RatsLink link = link(broker.uri(), "maestro", clock);
        MaestroPlatform platform = platform(home, broker.uri(), link, clock)) {
      try {
        long begin = System.nanoTime();
        startAll(platform.port(), hosts);
        row(
            "%d processes with %d containers joined".formatted(processes, containers),
            seconds(begin),
            "s");
        begin = System.nanoTime();
        List<Dial> dials = IntStream.range(0, containers).mapToObj(Dial::new).toList();
        Admission admission = new Admission();
        for (Dial dial : dials) {
          PahoTransport transport = new PahoTransport(broker.uri(), dial.id(), admission);
          members.add(dial.join(transport, site, clock, containers));
        }
        await(platform);
        row(
            "%d devices described, each with its agent in a container".formatted(containers),
            seconds(begin),
            "s");
        row("agents in other processes", elsewhere(platform), "agents");
        pursue(platform, hosts, dials);
      } finally {
        members.forEach(RatsMember::leave);
        members.forEach(RatsMember::close);
      }
    }
  }

  private RatsLink link(URI broker, String controller, Clock clock) {
    return BusLink.connect(controller, site, new PahoTransport(broker, controller), clock);
  }

  private MaestroPlatform platform(Home home, URI broker, RatsLink link, Clock clock) {
    return MaestroPlatform.start(
        PlatformSettings.of(site).brokerUri(Optional.of(broker.toString())).build(),
        new PlatformServices(
            CollectiveKnowledge.open(home, clock, KnowledgeSettings.inMemory()),
            new OptimalPlanner(),
            link,
            OtherNames.unrestricted(controller -> link(broker, controller, clock)),
            clock,
            DescriptionReader.of(home)::read));
  }

  private void startAll(int port, List<HostProcess> hosts) {
    ExecutorService starters = Executors.newFixedThreadPool(AT_ONCE);
    try {
      List<Future<?>> started = new ArrayList<>();
      for (int process = 0; process < processes; process++) {
        int number = process;
        int first = containers * process / processes;
        int next = containers * (process + 1) / processes;
        started.add(
            starters.submit(
                () ->
                    hosts.add(HostProcess.start(port, "process-" + number, first, next - first))));
      }
      for (Future<?> one : started) {
        one.get(ALL_WITHIN.toSeconds(), TimeUnit.SECONDS);
      }
    } catch (ExecutionException | TimeoutException e) {
      throw new IllegalStateException("Not all processes could be started.", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("The benchmark was interrupted.", e);
    } finally {
      starters.shutdownNow();
    }
  }

  private static double elsewhere(MaestroPlatform platform) {
    List<String> here = platform.topics();
    return platform.agents().stream()
        .map(AgentRow::container)
        .filter(container -> !here.contains(container))
        .count();
  }

  private void pursue(MaestroPlatform platform, List<HostProcess> hosts, List<Dial> dials) {
    int killed = Math.max(1, processes / KILLED_OF_TEN);
    List<HostProcess> doomed = new ArrayList<>(hosts);
    Collections.shuffle(doomed, chance);
    progress.accept("%d goals, and %d processes killed meanwhile.".formatted(goals, killed));
    Queue<GoalReport> reports = new ConcurrentLinkedQueue<>();
    Queue<Double> durations = new ConcurrentLinkedQueue<>();
    Semaphore free = new Semaphore(UNDER_WAY);
    CpuByPart before = CpuByPart.now();
    long begin = System.nanoTime();
    int dead = 0;
    for (int goal = 0; goal < goals; goal++) {
      if (dead < killed && goal >= goals * (dead + 1) / (killed + 1)) {
        doomed.get(dead++).kill();
      }
      acquire(free, 1);
      Dial dial = dials.get(goal % dials.size());
      int level = 1 - goal / dials.size() % 2;
      long stated = System.nanoTime();
      platform
          .desk()
          .pursue(
              SlParser.formula(
                  dial.isAt(level), platform.knowledge().home().vocabulary()::isFluent),
              id -> {},
              report -> {
                durations.add(seconds(stated));
                reports.add(report);
                if (reports.size() % TOLD_EACH == 0) {
                  progress.accept("%d goals ended.".formatted(reports.size()));
                }
                free.release();
              });
    }
    acquire(free, UNDER_WAY);
    double all = seconds(begin);
    Map<String, Double> taken = CpuByPart.now().since(before);
    row("goals ended", reports.size(), "goals");
    row("goals reached", (double) reports.stream().filter(GoalReport::reached).count(), "goals");
    row("processes killed meanwhile", dead, "processes");
    row("agents in other processes, at the end", elsewhere(platform), "agents");
    row("goals a second, %d at a time".formatted(UNDER_WAY), reports.size() / all, "goals/s");
    List<Double> sorted = durations.stream().sorted().toList();
    row("a goal, p50", sorted.get(sorted.size() / 2), "s");
    row("a goal, p99", sorted.get(sorted.size() * 99 / 100), "s");
    row("a goal, longest", sorted.get(sorted.size() - 1), "s");
    taken.forEach((part, seconds) -> row(PROCESSOR + part, seconds * 1e3 / goals, "ms"));
    TreeMap<String, Integer> reasons = new TreeMap<>();
    reports.stream()
        .filter(report -> !report.reached())
        .forEach(report -> reasons.merge(String.join(" ", report.reasons()), 1, Integer::sum));
    reasons.forEach((reason, count) -> progress.accept(count + " goals: " + reason));
  }

  private void acquire(Semaphore semaphore, int permits) {
    try {
      if (!semaphore.tryAcquire(permits, GOAL_WITHIN.toSeconds(), TimeUnit.SECONDS)) {
        throw new IllegalStateException(
            "A goal did not end within %d s.".formatted(GOAL_WITHIN.toSeconds()));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("The benchmark was interrupted.", e);
    }
  }

  private void await(MaestroPlatform platform) {
    long end = System.nanoTime() + ALL_WITHIN.toNanos();
    while (platform.presentMembers().size() < containers) {
      if (System.nanoTime() > end) {
        throw new IllegalStateException(
            "Of %d devices only %d can be used after %d s."
                .formatted(containers, platform.presentMembers().size(), ALL_WITHIN.toSeconds()));
      }
      LockSupport.parkNanos(20_000_000);
    }
  }

  private void row(String name, double value, String unit) {
    progress.accept("%s: %.2f %s".formatted(name, value, unit));
    rows.add(BenchReport.Row.of(name, value, unit));
  }

  private static double seconds(long beginNanos) {
    return (System.nanoTime() - beginNanos) / 1e9;
  }
}
