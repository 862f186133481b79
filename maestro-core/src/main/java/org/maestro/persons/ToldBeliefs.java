package org.maestro.persons;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * What was told the last time, so that the same is not told again and again: only before it is too
 * old, or when it has become likelier or less likely. Confined to one thread.
 */
final class ToldBeliefs {
  /** Beliefs on persons count for half a minute. */
  private static final Duration AGAIN = Duration.ofSeconds(20);

  private static final double NOTICEABLE = 0.05;

  private Map<String, Double> told = Map.of();
  private Instant at = Instant.MIN;

  /** Whether it is to be told; if it is, it is taken to have been. */
  boolean isNews(Map<String, Double> beliefs, Instant now) {
    boolean isNews =
        !beliefs.keySet().equals(told.keySet())
            || beliefs.entrySet().stream()
                .anyMatch(
                    belief ->
                        Math.abs(belief.getValue() - told.getOrDefault(belief.getKey(), 0.0))
                            >= NOTICEABLE)
            || !beliefs.isEmpty() && !at.plus(AGAIN).isAfter(now);
    if (isNews) {
      told = new LinkedHashMap<>(beliefs);
      at = now;
    }
    return isNews;
  }
}
