package org.maestro.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.IntFunction;
import org.maestro.experiment.running.Progress;

/**
 * The course of an experiment: one run after the other, and what those that are over have found.
 * Runs are carried out on one thread; any other may stop it and have the findings meanwhile.
 *
 * @param <R> what is kept of a run
 */
public final class Course<R> {
  private final int runs;
  private final IntFunction<R> carryingOut;
  private final Function<R, String> telling;
  private final Function<List<R>, Findings> finding;
  private final List<R> over = new ArrayList<>();
  private boolean stopped;

  /**
   * @param carryingOut of a run by its number, from 1
   * @param telling what came of a run, half a sentence
   * @param finding what runs show, one or more of the first ones
   */
  Course(
      int runs,
      IntFunction<R> carryingOut,
      Function<R, String> telling,
      Function<List<R>, Findings> finding) {
    this.runs = runs;
    this.carryingOut = carryingOut;
    this.telling = telling;
    this.finding = finding;
  }

  /** How many runs there are to be. */
  public int runs() {
    return runs;
  }

  /** How many of them are over. */
  public synchronized int done() {
    return over.size();
  }

  /** Carries out run after run, until all are over or it is stopped. */
  public void carryOut(Progress progress) {
    for (int run = 1; run <= runs && goesOn(); run++) {
      R carriedOut = carryingOut.apply(run);
      if (!counts(carriedOut)) {
        return;
      }
      progress.passed(run, runs, telling.apply(carriedOut));
    }
  }

  private synchronized boolean goesOn() {
    return !stopped;
  }

  private synchronized boolean counts(R run) {
    if (!stopped) {
      over.add(run);
    }
    return !stopped;
  }

  /** No further run counts, not even the one that is under way. */
  public synchronized void stop() {
    stopped = true;
  }

  /**
   * What the runs that are over show; it says so when these are not all.
   *
   * @throws IllegalStateException before any is over
   */
  public Findings findings() {
    List<R> counted = overByNow();
    if (counted.isEmpty()) {
      throw new IllegalStateException("No run is over yet, so that nothing was found.");
    }
    Findings findings = finding.apply(counted);
    if (counted.size() < runs) {
      findings
          .page()
          .notice(
              "Interrupted after %d of %d runs: what follows is of these alone."
                  .formatted(counted.size(), runs));
    }
    return findings;
  }

  private synchronized List<R> overByNow() {
    return List.copyOf(over);
  }
}
