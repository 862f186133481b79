package org.maestro.diary;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.DateTimeException;
import java.time.Instant;
import java.util.Optional;

/** Lines of the diary as lines of JSON. */
final class LineCodec {
  private static final ObjectMapper JSON = new ObjectMapper();

  private LineCodec() {}

  static String write(DiaryLine line) {
    ObjectNode node = JSON.createObjectNode().put("at", line.at().toString());
    if (line instanceof DiaryLine.Became became) {
      node.put("fact", became.fact());
    } else if (line instanceof DiaryLine.Asked asked) {
      node.put("asked", asked.id()).put("goal", asked.goal()).put("by", asked.requester());
    } else if (line instanceof DiaryLine.Over over) {
      node.put("over", over.id()).put("end", over.end()).put("reason", over.reason());
    }
    return node.toString();
  }

  /** Empty: the line is damaged, as the last one before a crash may be. */
  static Optional<DiaryLine> read(String line) {
    try {
      JsonNode node = JSON.readTree(line);
      Instant at = Instant.parse(node.path("at").asText());
      if (node.has("fact")) {
        return Optional.of(new DiaryLine.Became(at, node.path("fact").asText()));
      } else if (node.has("asked")) {
        return Optional.of(
            new DiaryLine.Asked(
                at,
                node.path("asked").asText(),
                node.path("goal").asText(),
                node.path("by").asText()));
      } else if (node.has("over")) {
        return Optional.of(
            new DiaryLine.Over(
                at,
                node.path("over").asText(),
                node.path("end").asText(),
                node.path("reason").asText()));
      }
      return Optional.of(new DiaryLine.Begun(at));
    } catch (JsonProcessingException | DateTimeException damaged) {
      return Optional.empty();
    }
  }
}
