package org.maestro.bench;

import jade.lang.acl.ACLMessage;
import java.io.ByteArrayInputStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.GoalReport;
import org.maestro.agents.content.Words;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteException;
import org.maestro.assembly.SiteSettings;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.random.Building;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.SlParser;

/**
 * Buildings that run: broker, platform, agents and simulated devices in one process, at the speed
 * of the world. How long one takes to be ready, how soon something is begun for a goal, how ten
 * goals at once fare, how soon all devices stand still, and how long it takes to end. A goal that
 * takes longer than two minutes is not waited for. For one thread.
 */
public final class RunningBench {
  /** As many devices, about. */
  public static final List<Integer> DEVICES = List.of(40, 200, 400, 1_000);

  private static final int DEVICES_PER_FLOOR = 400;
  private static final long SEED = 1;
  private static final String SITE = "bench-running";
  private static final long PATIENCE_SECONDS = 120;
  private static final long STOP_PATIENCE_SECONDS = 30;
  private static final int GOALS_AT_ONCE = 10;
  private static final int GOALS_BEFORE = 5;
  private static final double NANOS = 1e9;

  private final List<Integer> devices;
  private final Consumer<String> progress;
  private final List<BenchReport.Row> rows = new ArrayList<>();

  /** What is asked for; other rooms, things and persons for each number. */
  private enum Kind {
    LIGHT(5) {
      @Override
      String goal(int number, Building building) {
        return "(>= (illuminance z%d) 140)"
            .formatted(number * building.rooms() / GOALS_AT_ONCE % building.rooms());
      }
    },
    LOOK(5) {
      @Override
      String goal(int number, Building building) {
        return "(canSee ?agent Thing%d)".formatted((2 * number + 1) % building.things());
      }
    },
    FETCH(2) {
      @Override
      String goal(int number, Building building) {
        return "(nextTo Thing%d Person%d)"
            .formatted(2 * number % building.things(), number % building.persons());
      }
    };

    private final int goals;

    Kind(int goals) {
      this.goals = goals;
    }

    abstract String goal(int number, Building building);
  }

  /** A goal that was stated, and its end. */
  private record Stated(String goal, long begunNanos, CompletableFuture<Ended> end) {
    /** As long as it was waited for where it did not end. */
    double secondsUntil(Optional<Ended> ended) {
      return ended
          .map(end -> (end.atNanos() - begunNanos) / NANOS)
          .orElse((double) PATIENCE_SECONDS);
    }
  }

  /** What became of it. */
  private record Ended(GoalReport report, long atNanos) {}

  /**
   * @param devices of each building, about, in the order in which they are tried
   * @param progress told what is being done
   */
  public RunningBench(List<Integer> devices, Consumer<String> progress) {
    this.devices = List.copyOf(devices);
    this.progress = progress;
  }

  /** Measures, one building after the other; larger ones than one that does not open are left. */
  public BenchReport run() {
    for (int size : devices) {
      Building building = new Building(size, 1 + (size - 1) / DEVICES_PER_FLOOR, SEED);
      progress.accept("%d devices in %d rooms.".formatted(building.devices(), building.rooms()));
      try {
        run(building);
      } catch (SiteException e) {
        progress.accept("Ended here: " + e.getMessage());
        break;
      }
    }
    return new BenchReport("running", BenchReport.thisMachine(), rows);
  }

  private void run(Building building) {
    Home home = new HomeLoader().load(building.homeText(), "building.ttl");
    SiteSettings settings =
        SiteSettings.of(SITE, home)
            .scene(
                SceneLoader.load(
                    "building-scene.ttl",
                    new ByteArrayInputStream(building.sceneText().getBytes(StandardCharsets.UTF_8)),
                    home))
            .build();
    String of = building.devices() + " devices: ";
    long begin = System.nanoTime();
    LocalSite site = LocalSite.paced(settings, 1);
    try (site) {
      add(of + "ready after", System.nanoTime() - begin);
      rows.add(
          BenchReport.Row.of(
              of + "threads", ManagementFactory.getThreadMXBean().getThreadCount(), "threads"));
      rows.add(BenchReport.Row.of(of + "live heap", MemorySample.take(0).heapMiB(), "MiB"));
      progress.accept("It is ready. Goals one after the other.");
      oneByOne(site, building, of);
      progress.accept("%d goals at once, then a stop.".formatted(GOALS_AT_ONCE));
      atOnce(site, building, of);
      begin = System.nanoTime();
    }
    add(of + "ended after", System.nanoTime() - begin);
  }

  private void oneByOne(LocalSite site, Building building, String of) {
    for (Kind kind : Kind.values()) {
      List<Double> decisions = new ArrayList<>();
      double seconds = 0;
      int replans = 0;
      int reached = 0;
      for (int number = 0; number < kind.goals; number++) {
        Stated stated = state(site, kind.goal(number, building));
        Optional<Ended> ended = awaited(stated);
        seconds += stated.secondsUntil(ended);
        reached += reached(stated, ended);
        replans += ended.map(end -> end.report().replans()).orElse(0);
        ended
            .map(Ended::report)
            .filter(report -> report.calls() > 0)
            .ifPresent(report -> decisions.add(report.decisionMillis()));
      }
      String name = of + kind.name().toLowerCase(Locale.ROOT) + ", ";
      rows.add(BenchReport.Row.of(name + "reached of %d".formatted(kind.goals), reached, "goals"));
      decisions.stream()
          .sorted()
          .skip(decisions.size() / 2)
          .findFirst()
          .ifPresent(p50 -> rows.add(BenchReport.Row.of(name + "first call, p50", p50, "ms")));
      rows.add(BenchReport.Row.of(name + "ended, mean", seconds / kind.goals, "s"));
      rows.add(
          BenchReport.Row.of(name + "planned again, mean", (double) replans / kind.goals, "plans"));
    }
  }

  /** One if it was; if not, it is told why. */
  private int reached(Stated stated, Optional<Ended> ended) {
    if (ended.filter(end -> end.report().reached()).isPresent()) {
      return 1;
    }
    progress.accept(
        "Not reached: %s: %s"
            .formatted(
                stated.goal(),
                ended
                    .map(end -> String.join(" ", end.report().reasons()))
                    .orElse("no end within %d s.".formatted(PATIENCE_SECONDS))));
    return 0;
  }

  private void atOnce(LocalSite site, Building building, String of) {
    List<Stated> all = new ArrayList<>();
    for (int number = 0; number < GOALS_AT_ONCE; number++) {
      Kind kind = Kind.values()[number % Kind.values().length];
      all.add(state(site, kind.goal(GOALS_BEFORE + number, building)));
    }
    long stopped = stopWhenMoving(site);
    if (stopped >= 0) {
      add(of + "all that ran stands still after a stop, after", stopped);
    }
    double latest = 0;
    double sum = 0;
    int reached = 0;
    for (Stated stated : all) {
      Optional<Ended> ended = awaited(stated);
      double seconds = stated.secondsUntil(ended);
      latest = Math.max(latest, seconds);
      sum += seconds;
      reached += reached(stated, ended);
    }
    rows.add(BenchReport.Row.of(of + "ten at once, reached", reached, "goals"));
    rows.add(BenchReport.Row.of(of + "ten at once, ended, mean", sum / all.size(), "s"));
    rows.add(BenchReport.Row.of(of + "ten at once, ended, last", latest, "s"));
  }

  /**
   * Stops all devices once several of them are at work.
   *
   * @return nanoseconds until none of those calls runs; negative when that took too long
   */
  private static long stopWhenMoving(LocalSite site) {
    try (RatsLink link =
        BusLink.connect(
            "bench-witness",
            SITE,
            new PahoTransport(site.broker().orElseThrow(), SITE + "-bench-witness"),
            site.clock())) {
      long limit = System.nanoTime() + STOP_PATIENCE_SECONDS * 1_000_000_000L;
      Set<String> running = running(link);
      while (running.size() < 2 && System.nanoTime() < limit) {
        LockSupport.parkNanos(5_000_000);
        running = running(link);
      }
      long begin = System.nanoTime();
      site.platform()
          .desk()
          .request(
              ACLMessage.REQUEST,
              AgentNames.SUPERVISOR,
              Duration.ofSeconds(STOP_PATIENCE_SECONDS),
              reply -> {},
              Words.content("perform", Words.named("action", Words.name("stop"))));
      Set<String> left = new HashSet<>(running);
      while (!left.isEmpty() && System.nanoTime() < limit) {
        left.retainAll(running(link));
        LockSupport.parkNanos(1_000_000);
      }
      return left.isEmpty() ? System.nanoTime() - begin : -1;
    }
  }

  private static Set<String> running(RatsLink link) {
    Set<String> running = new HashSet<>();
    link.members()
        .forEach(member -> member.state().ifPresent(state -> running.addAll(state.running())));
    return running;
  }

  private static Stated state(LocalSite site, String goal) {
    long begin = System.nanoTime();
    CompletableFuture<Ended> end = new CompletableFuture<>();
    site.platform()
        .desk()
        .pursue(
            SlParser.formula(goal, site.platform().knowledge().home().vocabulary()::isFluent),
            id -> {},
            report -> end.complete(new Ended(report, System.nanoTime())));
    return new Stated(goal, begin, end);
  }

  private static Optional<Ended> awaited(Stated stated) {
    long left = stated.begunNanos() + PATIENCE_SECONDS * 1_000_000_000L - System.nanoTime();
    try {
      return Optional.of(stated.end().get(Math.max(1, left), TimeUnit.NANOSECONDS));
    } catch (TimeoutException late) {
      return Optional.empty();
    } catch (ExecutionException e) {
      throw new SiteException("The goal %s has no end.".formatted(stated.goal()), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SiteException("Interrupted while waiting for a goal.", e);
    }
  }

  private void add(String name, long nanos) {
    rows.add(BenchReport.Row.of(name, nanos / NANOS, "s"));
  }
}
