package org.maestro.bench.planning;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.maestro.bench.BenchReport;

/**
 * The processor time for which planning goes on that was cancelled: at several moments of problems
 * of several sizes, each the first of a process of its own, where nothing is compiled yet. For one
 * thread.
 */
public final class CancelBench {
  private static final long ENDED_WITHIN_SECONDS = 60;

  /**
   * A problem to be planned, and the moment of its cancellation, in milliseconds of processor time.
   */
  private record Moment(int agents, PlanningHome.Wish wish, int afterMilliseconds) {}

  private static final List<Moment> MOMENTS =
      List.of(
          new Moment(100, PlanningHome.Wish.TRANSPORT, 5),
          new Moment(100, PlanningHome.Wish.TRANSPORT, 20),
          new Moment(100, PlanningHome.Wish.ILLUMINATE, 35),
          new Moment(1_000, PlanningHome.Wish.ILLUMINATE, 50),
          new Moment(1_000, PlanningHome.Wish.TRANSPORT, 90),
          new Moment(100, PlanningHome.Wish.THREE_TRANSPORTS, 160),
          new Moment(100, PlanningHome.Wish.THREE_TRANSPORTS, 400),
          new Moment(1_000, PlanningHome.Wish.OBSERVE, 70),
          new Moment(1_000, PlanningHome.Wish.THREE_TRANSPORTS, 500));

  private final int runs;
  private final Consumer<String> progress;

  /**
   * @param runs of each moment, from 1
   * @param progress told what was measured each time
   */
  public CancelBench(int runs, Consumer<String> progress) {
    this.runs = runs;
    this.progress = progress;
  }

  public BenchReport run() {
    List<Double> all = new ArrayList<>();
    for (Moment moment : MOMENTS) {
      for (int run = 0; run < runs; run++) {
        String said = said(moment);
        progress.accept(
            "%d agents, %s, cancelled after %d ms: %s"
                .formatted(
                    moment.agents(), moment.wish().words(), moment.afterMilliseconds(), said));
        if (!said.equals("ended")) {
          all.add(Double.valueOf(said));
        }
      }
    }
    Collections.sort(all);
    List<BenchReport.Row> rows =
        all.isEmpty()
            ? List.of()
            : List.of(
                BenchReport.Row.of("cancelled in time", all.size(), "times"),
                BenchReport.Row.of("planning went on for, median", all.get(all.size() / 2), "ms"),
                BenchReport.Row.of("planning went on for, worst", all.get(all.size() - 1), "ms"));
    return new BenchReport("cancel", BenchReport.thisMachine(), rows);
  }

  private static String said(Moment moment) {
    try {
      Process process =
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-XX:+UseSerialGC",
                  "-cp",
                  System.getProperty("java.class.path"),
                  CancelledPlanner.class.getName(),
                  String.valueOf(moment.agents()),
                  moment.wish().name(),
                  String.valueOf(moment.afterMilliseconds()))
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      try {
        if (!process.waitFor(ENDED_WITHIN_SECONDS, TimeUnit.SECONDS) || process.exitValue() != 0) {
          throw new IllegalStateException("Planning that was cancelled did not end: " + moment);
        }
        return new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
      } finally {
        process.destroyForcibly();
      }
    } catch (IOException e) {
      throw new UncheckedIOException("A process for the benchmark could not be started.", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("Interrupted while planning was measured", e);
    }
  }
}
