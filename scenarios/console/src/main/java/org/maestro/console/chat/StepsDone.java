package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Collection;
import java.util.List;

/** What has become of the steps of plans, as the desk tells of them. */
final class StepsDone {
  private static final List<String> BEGUN = List.of("done", "under-way");

  private StepsDone() {}

  /** Whether one of them has done anything in these plans. */
  static boolean by(JsonNode plans, Collection<String> members) {
    for (JsonNode plan : plans.path("plans")) {
      for (JsonNode step : plan.path("steps")) {
        if (BEGUN.contains(step.path("state").asText())
            && members.contains(step.path("member").asText())) {
          return true;
        }
      }
    }
    return false;
  }
}
