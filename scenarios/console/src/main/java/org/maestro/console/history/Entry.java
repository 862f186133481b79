package org.maestro.console.history;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.json.JsonWriteFeature;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.Locale;
import java.util.Optional;

/**
 * One thing that was recorded, a line of JSON in a file.
 *
 * @param at by the wall's clock
 * @param clock simulated seconds since the platform's clock began
 */
record Entry(Instant at, double clock, Kind kind, JsonNode told) {
  /** A terminal obeys nothing that a device has said. */
  private static final JsonMapper MAPPER =
      JsonMapper.builder().enable(JsonWriteFeature.ESCAPE_NON_ASCII).build();

  enum Kind {
    /** All that is so; with it each file begins. */
    STATE,
    HOME,
    FACTS,
    GOALS,
    AGENTS,
    /** What became of a goal or of a member. */
    HAPPENING,
    /** What was measured since the figures before. */
    FIGURES
  }

  String line() {
    ObjectNode node = JsonNodeFactory.instance.objectNode();
    node.put("at", at.toString())
        .put("clock_s", clock)
        .put("kind", kind.name().toLowerCase(Locale.ROOT))
        .set("told", told);
    try {
      return MAPPER.writeValueAsString(node);
    } catch (JsonProcessingException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Reads a line back; empty when it is damaged, as the last one before a crash may be. */
  static Optional<Entry> read(String line) {
    try {
      JsonNode node = MAPPER.readTree(line);
      return Optional.of(
          new Entry(
              Instant.parse(node.path("at").asText()),
              node.path("clock_s").asDouble(),
              Kind.valueOf(node.path("kind").asText().toUpperCase(Locale.ROOT)),
              node.path("told")));
    } catch (JsonProcessingException | DateTimeException | IllegalArgumentException e) {
      return Optional.empty();
    }
  }
}
