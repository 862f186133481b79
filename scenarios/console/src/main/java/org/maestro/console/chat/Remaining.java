package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.Optional;
import java.util.Set;

/** How long what is left of a plan takes, as it was planned. */
final class Remaining {
  private static final Set<String> TO_COME = Set.of("waiting", "under-way");

  private Remaining() {}

  /**
   * Of the latest plan of a goal.
   *
   * @param plans the goal's, as the desk tells of them
   * @param now simulated time since the platform's start
   * @return empty when there is no plan, or nothing of it is left
   */
  static Optional<Duration> of(JsonNode plans, Duration now) {
    JsonNode all = plans.path("plans");
    if (all.isEmpty()) {
      return Optional.empty();
    }
    double nowSeconds = now.toMillis() / 1000.0;
    double begin = nowSeconds;
    double end = -1;
    JsonNode steps = all.get(all.size() - 1).path("steps");
    for (JsonNode step : steps) {
      if (step.path("begun_s").isNumber()) {
        begin = step.path("begun_s").asDouble() - step.path("start_s").asDouble();
      }
    }
    for (JsonNode step : steps) {
      if (TO_COME.contains(step.path("state").asText())) {
        end =
            Math.max(
                end, begin + step.path("start_s").asDouble() + step.path("duration_s").asDouble());
      }
    }
    return end < 0
        ? Optional.empty()
        : Optional.of(Duration.ofMillis(Math.max(0, Math.round((end - nowSeconds) * 1000))));
  }
}
