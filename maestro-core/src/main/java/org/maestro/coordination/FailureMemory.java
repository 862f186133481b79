package org.maestro.coordination;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Function;
import org.maestro.planning.StepKey;

/**
 * Remembers failed steps with the facts under their preconditions. A step that failed twice with
 * the same facts is barred until one of them changes: so that a goal never tries the same in vain
 * for ever. Before the goal is given up each has one chance more.
 */
final class FailureMemory {
  private static final int CHANCES = 2;

  private record Failures(String facts, int count, int chances, String problem) {
    String inWords() {
      return "it failed %d times with the same facts: %s".formatted(count, problem);
    }
  }

  private final Map<StepKey, Failures> failures = new LinkedHashMap<>();

  /**
   * @param problem what its member says
   */
  void note(StepKey step, String facts, String problem) {
    String said = problem.endsWith(".") ? problem.substring(0, problem.length() - 1) : problem;
    Failures before = failures.get(step);
    failures.put(
        step,
        before != null && before.facts().equals(facts)
            ? new Failures(facts, before.count() + 1, before.chances(), said)
            : new Failures(facts, 1, CHANCES, said));
  }

  /**
   * The steps barred now, and why; {@code factsUnder} tells the facts under a step's precondition
   * as they are.
   */
  Map<StepKey, String> barred(Function<StepKey, String> factsUnder) {
    Map<StepKey, String> barred = new LinkedHashMap<>();
    failures.forEach(
        (step, failed) -> {
          if (isBarred(step, failed, factsUnder)) {
            barred.put(step, failed.inWords());
          }
        });
    return barred;
  }

  private static boolean isBarred(
      StepKey step, Failures failed, Function<StepKey, String> factsUnder) {
    return failed.count() >= failed.chances() && failed.facts().equals(factsUnder.apply(step));
  }

  /** Gives each barred step that had none its last chance; returns whether there was any. */
  boolean giveLastChances(Function<StepKey, String> factsUnder) {
    boolean[] any = new boolean[1];
    failures.replaceAll(
        (step, failed) -> {
          if (failed.chances() > CHANCES || !isBarred(step, failed, factsUnder)) {
            return failed;
          }
          any[0] = true;
          return new Failures(failed.facts(), failed.count(), CHANCES + 1, failed.problem());
        });
    return any[0];
  }
}
