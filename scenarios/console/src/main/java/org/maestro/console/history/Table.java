package org.maestro.console.history;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * The rows of a document, such as its goals, as they stand after all changes so far. What in a row
 * goes on with the clock by itself is no change. Not thread-safe.
 */
final class Table {
  private static final String AGE = "age_s";
  private static final String LEFT = "deadline_s";
  private static final String WORTH = "worth";
  private static final List<String> GROWING = List.of("elapsed_s", "urgency", "weight");

  private final Function<JsonNode, String> key;
  private final Map<String, Row> rows = new LinkedHashMap<>();

  /**
   * @param clock when the ages in it were so
   */
  private record Row(JsonNode node, double clock) {
    JsonNode at(double now) {
      ObjectNode copy = node.deepCopy();
      moved(copy, AGE, now - clock);
      moved(copy, LEFT, clock - now);
      return copy;
    }

    private static void moved(ObjectNode row, String member, double by) {
      if (row.path(member).isNumber()) {
        row.put(member, Math.round((row.path(member).asDouble() + by) * 1000) / 1000.0);
      }
    }
  }

  /**
   * @param key by which a row is known again
   */
  Table(Function<JsonNode, String> key) {
    this.key = key;
  }

  Optional<JsonNode> find(String its) {
    return Optional.ofNullable(rows.get(its)).map(Row::node);
  }

  String key(JsonNode row) {
    return key.apply(row);
  }

  /** What these rows change: the rows that are to be set, and the keys of those that are gone. */
  ObjectNode change(JsonNode wanted) {
    ObjectNode change = JsonNodeFactory.instance.objectNode();
    ArrayNode set = change.putArray("set");
    Set<String> gone = new HashSet<>(rows.keySet());
    for (JsonNode row : wanted) {
      String its = key.apply(row);
      gone.remove(its);
      Row before = rows.get(its);
      if (before == null || !still(before.node()).equals(still(row))) {
        set.add(row);
      }
    }
    ArrayNode lost = change.putArray("gone");
    gone.forEach(lost::add);
    return change;
  }

  private static JsonNode still(JsonNode row) {
    ObjectNode copy = row.deepCopy();
    copy.remove(AGE);
    copy.remove(LEFT);
    if (copy.path(WORTH) instanceof ObjectNode worth) {
      worth.remove(GROWING);
    }
    return copy;
  }

  void take(JsonNode change, double clock) {
    change.path("gone").forEach(its -> rows.remove(its.asText()));
    change.path("set").forEach(row -> set(row, clock));
  }

  private void set(JsonNode row, double clock) {
    rows.put(key.apply(row), new Row(row, clock));
  }

  /** Takes over what another one knows under a key, of when it was so. */
  void adopt(Table other, String its) {
    Optional.ofNullable(other.rows.get(its)).ifPresent(row -> rows.put(key.apply(row.node()), row));
  }

  /** From now on there are these alone. */
  void replace(JsonNode wanted, double clock) {
    rows.clear();
    wanted.forEach(row -> set(row, clock));
  }

  /** All of them, as they were told. */
  Stream<JsonNode> all() {
    return rows.values().stream().map(Row::node);
  }

  /** All of them, with the ages of then. */
  ArrayNode rows(double clock) {
    ArrayNode array = JsonNodeFactory.instance.arrayNode();
    rows.values().forEach(row -> array.add(row.at(clock)));
    return array;
  }
}
