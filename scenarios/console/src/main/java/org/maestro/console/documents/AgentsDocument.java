package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import java.util.function.Predicate;
import org.maestro.agents.content.Words;

/** A platform's agents, and the members that they stand for. */
public final class AgentsDocument {
  private AgentsDocument() {}

  /**
   * @param lines of the platform's tables, as the supervisor tells them
   * @param shown the containers of whose agents is told
   */
  public static JsonNode of(List<Words> lines, Predicate<String> shown) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode agents = document.node().putArray("agents");
    lines.stream()
        .filter(line -> line.string("place").isEmpty())
        .filter(line -> shown.test(line.string("container").orElse("")))
        .forEach(
            line ->
                JsonMembers.in(agents)
                    .text("agent", line.string("agent"))
                    .text("container", line.string("container"))
                    .words("members", line.strings("members"))
                    .words("drivers", line.strings("drivers"))
                    .text("phase", line.string("phase"))
                    .text("state", line.string("state"))
                    .words("disabled", line.strings("disabled"))
                    .text("life", line.string("life"))
                    .words("services", line.strings("services"))
                    .text("why", line.string("why"))
                    .text("since", line.string("since"))
                    .number("age_s", line, "age"));
    return document.node();
  }
}
