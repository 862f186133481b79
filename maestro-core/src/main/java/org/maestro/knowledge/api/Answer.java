package org.maestro.knowledge.api;

import java.time.Duration;
import java.time.Instant;
import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The answer to a question, and on whose word it rests.
 *
 * @param binding of the question's free variables
 * @param because the beliefs that the answer was drawn from, the oldest first; last what stands in
 *     the home, which may have been so for ever
 * @param at when it was so
 */
public record Answer(Truth truth, Map<String, Term> binding, List<Belief> because, Instant at) {
  public Answer {
    binding = Collections.unmodifiableMap(new LinkedHashMap<>(binding));
    because =
        because.stream()
            .distinct()
            .sorted(
                Comparator.comparing(Answer::standsInHome)
                    .thenComparing(Belief::since)
                    .thenComparing(Belief::fact))
            .toList();
  }

  private static boolean standsInHome(Belief belief) {
    return belief.source().kind() == Source.Kind.DESCRIBED;
  }

  /**
   * As old as the oldest belief that it was drawn from, or as the platform where all that stands in
   * the home; empty when there is none.
   */
  public Optional<Duration> age() {
    return because.stream().findFirst().map(belief -> belief.age(at));
  }

  /** As sure as the least sure of them. */
  public double confidence() {
    return because.stream().mapToDouble(Belief::confidence).min().orElse(1);
  }
}
