package org.maestro.launch;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Set;
import org.maestro.coordination.api.Sentences;

/** The worth of a goal as a row for people: the formulas of ADE, 4.1, with the numbers in them. */
final class WorthRow {
  private static final String COUNTS_AS_ANY = "100 (none stated)";

  /** What is over stands before nobody. */
  private static final Set<String> ENDS = Set.of("achieved", "failed", "cancelled");

  private WorthRow() {}

  static List<String> of(JsonNode goal) {
    JsonNode worth = goal.path("worth");
    boolean isStated = worth.isObject();
    boolean isOver = ENDS.contains(goal.path("state").asText());
    return List.of(
        JsonRows.text(goal, "id"),
        JsonRows.text(goal, "goal"),
        JsonRows.text(goal, "state"),
        goal.path("priority").asText(),
        isStated ? number(worth, "weight") : isOver ? "-" : COUNTS_AS_ANY,
        isStated ? utility(worth) : "-",
        isStated ? urgency(worth) : "-",
        goal.path("detail").asText(""));
  }

  private static String utility(JsonNode worth) {
    return "%s = %s·%s − %s"
        .formatted(
            number(worth, "utility"),
            number(worth, "chance"),
            number(worth, "benefit"),
            number(worth, "cost"));
  }

  private static String urgency(JsonNode worth) {
    if (!worth.path("allowed_s").isNumber()) {
      return number(worth, "urgency");
    }
    double allowed = worth.path("allowed_s").asDouble();
    double elapsed = Math.min(worth.path("elapsed_s").asDouble(), allowed);
    return "%s = (%s s / %s s)·(%s − %s) + %s"
        .formatted(
            number(worth, "urgency"),
            Sentences.number(elapsed),
            Sentences.number(allowed),
            number(worth, "urgency_to"),
            number(worth, "urgency_from"),
            number(worth, "urgency_from"));
  }

  private static String number(JsonNode worth, String name) {
    return worth.path(name).isNumber() ? Sentences.number(worth.path(name).asDouble()) : "unknown";
  }
}
