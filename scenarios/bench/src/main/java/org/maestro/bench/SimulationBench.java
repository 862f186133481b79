package org.maestro.bench;

import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.maestro.agents.content.GoalReport;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.ontology.home.Home;
import org.maestro.sim.scene.Scene;
import org.maestro.sl.SlParser;

/**
 * The speed of the simulated world: alone (physics and members on the stepped clock) as a multiple
 * of real time, and with the whole platform as runs a minute. Each figure stands beside what is
 * demanded of it. For one thread.
 */
public final class SimulationBench {
  private static final double NANOS = 1e9;
  private static final double NANOS_PER_MILLI = 1e6;
  private static final double MINUTE = 60;
  private static final Duration SLICE = Duration.ofSeconds(20);
  private static final Duration LONGEST_RUN = Duration.ofMinutes(10);
  private static final double DEMANDED_ARENA = 1000;
  private static final double DEMANDED_LARGE = 50;
  private static final double DEMANDED_RUNS = 20;
  private static final int WARM_UP_RUNS = 2;

  /** 18 rooms of five devices, and ten robots: 100 devices. */
  private static final LargeHome LARGE = new LargeHome(18, 10, 2);

  private final Home arena;
  private final Scene arenaScene;
  private final String goal;
  private final Duration wallTime;
  private final Consumer<String> progress;
  private final List<BenchReport.Row> rows = new ArrayList<>();

  /**
   * @param goal which the platform pursues in the arena
   * @param wallTime for which each figure is measured, after as long a time to warm up
   * @param progress told what is being done
   */
  public SimulationBench(
      Home arena, Scene arenaScene, String goal, Duration wallTime, Consumer<String> progress) {
    this.arena = arena;
    this.arenaScene = arenaScene;
    this.goal = goal;
    this.wallTime = wallTime;
    this.progress = progress;
  }

  public BenchReport run() {
    alone("the arena alone, %d devices", arena, arenaScene, DEMANDED_ARENA);
    Home large = LARGE.home();
    alone("a large home alone, %d devices, 10 robots", large, LARGE.scene(large), DEMANDED_LARGE);
    withPlatform();
    return new BenchReport("sim", BenchReport.thisMachine(), rows);
  }

  private void alone(String name, Home home, Scene scene, double demanded) {
    try (BusyWorld world = new BusyWorld(home, scene, 1)) {
      String what = name.formatted(world.devices());
      progress.accept("Simulating " + what + ".");
      long begin = System.nanoTime();
      while (System.nanoTime() - begin < wallTime.toNanos()) {
        world.run(SLICE);
      }
      int before = world.carried();
      long begun = System.nanoTime();
      long begunOnCore = coreNanos();
      double simulated = 0;
      while (System.nanoTime() - begun < wallTime.toNanos()) {
        world.run(SLICE);
        simulated += SLICE.toSeconds();
      }
      double wall = (System.nanoTime() - begun) / NANOS;
      double onCore = (coreNanos() - begunOnCore) / NANOS;
      rows.add(demanding(what + ", on one core", simulated / onCore, "x real", demanded));
      rows.add(BenchReport.Row.of(what + ", by the wall's clock", simulated / wall, "x real"));
      rows.add(
          BenchReport.Row.of(
              what + ": things carried an hour",
              (world.carried() - before) * Duration.ofHours(1).toSeconds() / simulated,
              ""));
    }
  }

  /** What this thread, which alone does the work, has had of a core: others' load is left out. */
  private static long coreNanos() {
    return ManagementFactory.getThreadMXBean().getCurrentThreadCpuTime();
  }

  /** The baseline is what is demanded. */
  private static BenchReport.Row demanding(
      String name, double value, String unit, double demanded) {
    return new BenchReport.Row(
        name + " (demanded: %.0f)".formatted(demanded), value, unit, OptionalDouble.of(demanded));
  }

  private void withPlatform() {
    progress.accept("Runs of the arena with the whole platform.");
    for (int i = 0; i < WARM_UP_RUNS; i++) {
      platformRun(i, new double[3]);
    }
    double[] nanos = new double[3];
    int runs = 0;
    double simulated = 0;
    long begun = System.nanoTime();
    while (System.nanoTime() - begun < wallTime.toNanos()) {
      simulated += platformRun(WARM_UP_RUNS + runs, nanos);
      runs++;
    }
    double wall = (System.nanoTime() - begun) / NANOS;
    rows.add(
        demanding(
            "arena with platform and agents", runs / wall * MINUTE, "runs/min", DEMANDED_RUNS));
    rows.add(
        BenchReport.Row.of("  starting the platform", nanos[0] / runs / NANOS_PER_MILLI, "ms"));
    rows.add(BenchReport.Row.of("  the goal", nanos[1] / runs / NANOS_PER_MILLI, "ms"));
    rows.add(BenchReport.Row.of("  stopping it", nanos[2] / runs / NANOS_PER_MILLI, "ms"));
    rows.add(BenchReport.Row.of("  simulated seconds of a run", simulated / runs, "s"));
  }

  /** Returns the simulated seconds that the goal took; adds wall times to the sums. */
  private double platformRun(long seed, double[] sums) {
    long begun = System.nanoTime();
    LocalSite site =
        LocalSite.stepped(SiteSettings.of("bench-sim", arena).scene(arenaScene).seed(seed).build());
    double seconds;
    long started;
    long ended;
    try (site) {
      started = System.nanoTime();
      CompletableFuture<GoalReport> report = new CompletableFuture<>();
      site.platform().desk().pursue(SlParser.formula(goal), id -> {}, report::complete);
      if (!site.runUntil(report::isDone, LONGEST_RUN) || !report.join().reached()) {
        throw new IllegalStateException(
            "The goal %s was not reached with seed %d.".formatted(goal, seed));
      }
      seconds = report.join().duration().toNanos() / NANOS;
      ended = System.nanoTime();
    }
    sums[0] += started - begun;
    sums[1] += ended - started;
    sums[2] += System.nanoTime() - ended;
    return seconds;
  }
}
