package org.maestro.bench;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.function.Consumer;
import org.maestro.chaos.Chaos;
import org.maestro.chaos.ChaosRun;

/** Random faults of all kinds in random homes, for some time, or one seed of it to see it again. */
public final class ChaosBench {
  private final OptionalLong only;
  private final long first;
  private final Duration wallTime;
  private final Consumer<String> progress;

  /**
   * @param only the one seed to carry out, with its story; empty: as many as there is time for
   * @param first the first of many
   * @param wallTime for all of them
   */
  public ChaosBench(OptionalLong only, long first, Duration wallTime, Consumer<String> progress) {
    this.only = only;
    this.first = first;
    this.wallTime = wallTime;
    this.progress = progress;
  }

  public BenchReport run() {
    return only.isPresent() ? one(only.getAsLong()) : many();
  }

  private BenchReport one(long seed) {
    ChaosRun run = ChaosRun.of(seed);
    List<String> summary = new ArrayList<>();
    summary.addAll(run.story().lines().toList());
    summary.addAll(run.isClean() ? List.of("Nothing was found.") : run.findings());
    return new BenchReport(
        "chaos",
        BenchReport.thisMachine(),
        List.of(BenchReport.Row.of("findings", run.findings().size(), "")),
        summary);
  }

  private BenchReport many() {
    Chaos chaos = Chaos.run(first, wallTime, progress);
    List<BenchReport.Row> rows = new ArrayList<>();
    rows.add(BenchReport.Row.of("seeds from " + first, chaos.runs(), ""));
    rows.add(BenchReport.Row.of("seeds that failed", chaos.failed().size(), ""));
    chaos
        .claims()
        .forEach((kind, goals) -> rows.add(BenchReport.Row.of("  " + kind, goals, "goals")));
    chaos
        .kinds()
        .forEach((kind, seeds) -> rows.add(BenchReport.Row.of("  " + kind, seeds, "seeds")));
    return new BenchReport(
        "chaos",
        BenchReport.thisMachine(),
        rows,
        chaos.failed().stream().map(ChaosRun::command).toList());
  }
}
