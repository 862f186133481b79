package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.maestro.coordination.api.StoryEntry;

/** A goal's story: simulated time, what kind of news it is, and the sentence. */
public final class StoryDocument {
  private StoryDocument() {}

  public static JsonNode of(String goal, List<StoryEntry> story) {
    JsonMembers document = JsonMembers.empty().text("goal", goal);
    ArrayNode entries = document.node().putArray("story");
    story.forEach(entry -> add(JsonMembers.in(entries), entry));
    return document.node();
  }

  /** The members of one entry. */
  static JsonMembers add(JsonMembers row, StoryEntry entry) {
    return row.number("at_s", entry.at().toMillis() / 1000.0)
        .text("kind", entry.kind().name().toLowerCase(Locale.ROOT))
        .text("text", entry.text());
  }

  /** One entry by itself, with its goal. */
  public static JsonNode of(StoryEntry entry) {
    return add(JsonMembers.empty().text("goal", entry.goalId()), entry).node();
  }

  /** Reads the document back. */
  public static List<StoryEntry> read(JsonNode document) {
    String goal = document.path("goal").asText();
    List<StoryEntry> story = new ArrayList<>();
    for (JsonNode entry : document.path("story")) {
      story.add(
          new StoryEntry(
              goal,
              Duration.ofMillis(Math.round(entry.path("at_s").asDouble() * 1000)),
              StoryEntry.Kind.valueOf(entry.path("kind").asText().toUpperCase(Locale.ROOT)),
              entry.path("text").asText()));
    }
    return story;
  }
}
