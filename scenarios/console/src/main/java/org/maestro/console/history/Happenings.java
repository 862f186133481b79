package org.maestro.console.history;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** What becomes of goals and members, as their rows change. */
final class Happenings {
  /** Who is met for the first time, and has been so for longer, became so before anybody looked. */
  private static final double LATELY_SECONDS = 10;

  private static final Map<String, String> OF_GOALS =
      Map.of(
          "achieved", "reached",
          "holding", "reached",
          "failed", "failed",
          "cancelled", "cancelled");

  private static final Set<String> BEFORE_THE_BEGIN = Set.of("submitted", "planning", "waiting");
  private static final Set<String> AWAY = Set.of("lost", "disconnected");

  private Happenings() {}

  /**
   * Of goals.
   *
   * @param goals as they were
   * @param speed of the clock by which rows have their ages
   */
  static List<ObjectNode> ofGoals(JsonNode change, Table goals, double speed) {
    List<ObjectNode> happenings = new ArrayList<>();
    for (JsonNode goal : change.path("set")) {
      Optional<JsonNode> before = goals.find(goals.key(goal));
      String was = before.map(row -> row.path("state").asText()).orElse("submitted");
      String is = goal.path("state").asText();
      if (before.isEmpty()) {
        if (!isLate(goal, speed)) {
          continue;
        }
        happenings.add(ofGoal(goal, "stated"));
      }
      if (is.equals("running") && BEFORE_THE_BEGIN.contains(was)) {
        happenings.add(ofGoal(goal, "begun"));
      }
      if (!is.equals(was) && OF_GOALS.containsKey(is)) {
        happenings.add(ofGoal(goal, OF_GOALS.get(is)));
      }
    }
    return happenings;
  }

  private static ObjectNode ofGoal(JsonNode goal, String what) {
    return happening("goal", what, goal.path("id").asText())
        .put("text", goal.path("goal").asText());
  }

  /** That a goal is planned again is told in its story. */
  static Optional<ObjectNode> ofStory(JsonNode entry) {
    return entry.path("kind").asText().equals("replan")
        ? Optional.of(
            happening("goal", "replanned", entry.path("goal").asText())
                .put("text", entry.path("text").asText()))
        : Optional.empty();
  }

  /** Of the members for which agents stand. */
  static List<ObjectNode> ofAgents(JsonNode change, Table agents, double speed) {
    List<ObjectNode> happenings = new ArrayList<>();
    for (JsonNode agent : change.path("set")) {
      Optional<JsonNode> before = agents.find(agents.key(agent));
      if (before.isEmpty() && !isLate(agent, speed)) {
        continue;
      }
      String was = before.map(row -> row.path("phase").asText()).orElse("absent");
      becameOf(was, agent.path("phase").asText())
          .ifPresent(
              what ->
                  agent
                      .path("members")
                      .forEach(
                          member ->
                              happenings.add(
                                  happening("member", what, member.asText())
                                      .set("text", agent.path("why")))));
    }
    return happenings;
  }

  private static Optional<String> becameOf(String was, String is) {
    if (was.equals(is)) {
      return Optional.empty();
    }
    return Optional.ofNullable(
        switch (is) {
          case "ready" -> AWAY.contains(was) ? "returned" : "joined";
          case "lost" -> "lost";
          case "disconnected" -> "left";
          case "refused" -> "refused";
          default -> null;
        });
  }

  private static boolean isLate(JsonNode row, double speed) {
    return row.path("age_s").asDouble() < LATELY_SECONDS * speed;
  }

  private static ObjectNode happening(String of, String what, String name) {
    return JsonNodeFactory.instance.objectNode().put("of", of).put("what", what).put("name", name);
  }
}
