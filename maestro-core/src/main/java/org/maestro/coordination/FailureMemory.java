package org.maestro.coordination;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.maestro.planning.StepKey;

/**
 * Remembers failed steps with the facts under their preconditions. A step that failed twice with
 * the same facts is barred until one of them changes: so that a goal never tries the same in vain
 * for ever.
 */
final class FailureMemory {
  private static final int CHANCES = 2;

  private record Failures(String facts, int count) {}

  private final Map<StepKey, Failures> failures = new HashMap<>();

  void note(StepKey step, String facts) {
    Failures before = failures.get(step);
    boolean same = before != null && before.facts().equals(facts);
    failures.put(step, new Failures(facts, same ? before.count() + 1 : 1));
  }

  /**
   * The steps barred now; {@code factsUnder} tells the facts under a step's precondition as they
   * are.
   */
  Set<StepKey> barred(Function<StepKey, String> factsUnder) {
    return failures.entrySet().stream()
        .filter(e -> e.getValue().count() >= CHANCES)
        .filter(e -> e.getValue().facts().equals(factsUnder.apply(e.getKey())))
        .map(Map.Entry::getKey)
        .collect(Collectors.toUnmodifiableSet());
  }
}
