package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.agents.content.Words;

/** A platform's containers, with the agents of each. */
public final class ContainersDocument {
  private static final List<String> STARTS = List.of("directory", "command");

  private ContainersDocument() {}

  /**
   * @param lines of the platform's tables, as the supervisor tells them
   * @param shown the containers that are told of
   */
  public static JsonNode of(List<Words> lines, Predicate<String> shown) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode containers = document.node().putArray("containers");
    lines.stream()
        .filter(line -> line.string("place").filter(shown).isPresent())
        .forEach(line -> add(JsonMembers.in(containers), line));
    return document.node();
  }

  private static void add(JsonMembers row, Words line) {
    Optional<Words> start = line.find("started").filter(its -> its.string("pid").isPresent());
    row.text("container", line.string("place"))
        .text("process", line.string("process"))
        .words("topics", line.strings("topics"))
        .words("provides", line.strings("provides"))
        .text("address", line.string("address"))
        .text("machine", start.flatMap(its -> its.string("machine")));
    start
        .flatMap(its -> its.string("pid"))
        .ifPresentOrElse(
            pid -> row.node().put("pid", Long.parseLong(pid)), () -> row.node().putNull("pid"));
    STARTS.forEach(part -> row.text(part, start.flatMap(its -> its.string(part))));
    row.words("agents", line.strings("holds"))
        .text("since", line.string("since"))
        .number("age_s", line, "age");
  }
}
