package org.maestro.console.references;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.StreamSupport;

/**
 * An agent that there is.
 *
 * @param members for which it stands
 * @param hasMembers whether they are on the bus, as far as is known
 */
record RunningAgent(String name, String container, List<String> members, boolean hasMembers) {
  private static final Set<String> OFF_THE_BUS =
      Set.of("absent", "disconnected", "lost", "refused");

  RunningAgent {
    members = List.copyOf(members);
  }

  /**
   * @param agents the document that lists all agents
   */
  static List<RunningAgent> of(JsonNode agents) {
    return StreamSupport.stream(agents.path("agents").spliterator(), false)
        .filter(row -> row.path("agent").isTextual() && !row.path("life").asText().equals("gone"))
        .map(
            row ->
                new RunningAgent(
                    row.path("agent").asText(),
                    row.path("container").asText(),
                    texts(row.path("members")),
                    !OFF_THE_BUS.contains(row.path("phase").asText())))
        .toList();
  }

  private static List<String> texts(JsonNode array) {
    List<String> texts = new ArrayList<>();
    array.forEach(text -> texts.add(text.asText()));
    return texts;
  }
}
