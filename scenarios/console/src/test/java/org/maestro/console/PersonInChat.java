package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.awaitility.Awaitility;

/** A person who speaks in the chat, in a room. */
record PersonInChat(ServedHome home, String person, String room) {
  private static final Duration LIMIT = Duration.ofSeconds(60);

  /** Says it, and waits until something is told in which that stands; all that was told then. */
  List<String> says(String text, String awaited) throws Exception {
    return says(text, "en", awaited);
  }

  List<String> says(String text, String language, String awaited) throws Exception {
    JsonNode body =
        JsonNodeFactory.instance
            .objectNode()
            .put("person", person)
            .put("room", room)
            .put("text", text)
            .put("language", language);
    long number = home.post("/chat", body.toString()).document().path("number").asLong();
    Awaitility.await(text)
        .atMost(LIMIT)
        .untilAsserted(() -> assertThat(told(number)).anyMatch(line -> line.contains(awaited)));
    return told(number);
  }

  /** What was told since she said it. */
  private List<String> told(long since) {
    List<String> told = new ArrayList<>();
    try {
      for (JsonNode entry : home.get("/chat").document().path("entries")) {
        if (entry.path("number").asLong() > since && !entry.path("kind").asText().equals("said")) {
          told.add(entry.path("text").asText());
        }
      }
    } catch (Exception e) {
      throw new AssertionError(e);
    }
    return told;
  }
}
