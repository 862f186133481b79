package org.maestro.console.trace;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.time.Duration;
import java.util.Comparator;
import java.util.OptionalInt;
import org.maestro.console.documents.JsonMembers;

/** The document of a goal's trace, in the order in which things were said. */
final class TraceDocument {
  private TraceDocument() {}

  static JsonNode of(String goal, GoalTrace trace) {
    JsonMembers document = JsonMembers.empty().text("goal", goal);
    document.node().put("dropped", trace.dropped());
    ArrayNode entries = document.node().putArray("trace");
    trace.entries().stream()
        .sorted(Comparator.comparing(TraceEntry::at))
        .forEach(entry -> add(JsonMembers.in(entries), entry));
    return document.node();
  }

  private static void add(JsonMembers row, TraceEntry entry) {
    row.number("at_s", seconds(entry.at()))
        .text("at", entry.wall().toString())
        .text("layer", entry.layer().word())
        .text("kind", entry.kind())
        .text("from", entry.from())
        .text("to", entry.to())
        .text("call", entry.call());
    row.node().put("text", entry.text());
    row.number("times", OptionalInt.of(entry.times())).number("until_s", seconds(entry.until()));
  }

  private static double seconds(Duration time) {
    return time.toMillis() / 1000.0;
  }
}
