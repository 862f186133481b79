package org.maestro.chaos;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.maestro.random.Verdict;

/**
 * Many chaos runs, one after the other, seeds in order.
 *
 * @param runs so many were carried out
 * @param claims how often the judge found what of a goal
 * @param failed those in which something was found
 */
public record Chaos(int runs, Map<Verdict.Kind, Integer> claims, List<ChaosRun> failed) {

  /** Seeds after which it says how far it is. */
  private static final int BETWEEN_SIGNS = 20;

  public Chaos {
    claims = Collections.unmodifiableMap(new TreeMap<>(claims));
    failed = List.copyOf(failed);
  }

  /**
   * Runs until the time is over.
   *
   * @param first the first seed
   * @param told of each seed that failed, and now and then of how far it is
   */
  public static Chaos run(long first, Duration wallTime, Consumer<String> told) {
    long end = System.nanoTime() + wallTime.toNanos();
    List<ChaosRun> failed = new ArrayList<>();
    Map<Verdict.Kind, Integer> claims = new TreeMap<>();
    int runs = 0;
    while (runs == 0 || System.nanoTime() < end) {
      ChaosRun run = ChaosRun.of(first + runs);
      runs++;
      run.claims().forEach(kind -> claims.merge(kind, 1, Integer::sum));
      if (!run.isClean()) {
        failed.add(run);
        told.accept("seed %d: %s".formatted(run.seed(), String.join(" | ", run.findings())));
      } else if (runs % BETWEEN_SIGNS == 0) {
        told.accept("%d seeds up to %d".formatted(runs, run.seed()));
      }
    }
    return new Chaos(runs, claims, failed);
  }

  /** How many seeds had a finding of each kind. */
  public Map<String, Integer> kinds() {
    Map<String, Integer> kinds = new TreeMap<>();
    failed.forEach(
        run ->
            run.findings().stream()
                .map(finding -> finding.split(" ")[0])
                .distinct()
                .forEach(kind -> kinds.merge(kind, 1, Integer::sum)));
    return kinds;
  }
}
