package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.maestro.ontology.home.ReadingRights;

/** What a sentence that was heard word by word is answered by, as its conversation has it. */
final class HeardAnswer {
  private HeardAnswer() {}

  /**
   * @param heard the document of what comes of the whole
   * @param all what all may read who look at the conversation
   */
  static List<ChatEvent> of(JsonNode heard, ReadingRights all) {
    List<ChatEvent> told = new ArrayList<>();
    String means = heard.path("means").asText();
    heard.path("goals").forEach(id -> told.add(new ChatEvent.Understood(id.asText(), means)));
    if (heard.has("reply")) {
      Optional<String> objection = all.objection(Set.of(means.split("[()\\s]+")));
      told.add(new ChatEvent.Told("", objection.orElse(heard.path("reply").asText())));
    }
    if (heard.has("asks")) {
      told.add(new ChatEvent.Asked(heard.path("asks").asText(), List.of()));
    }
    if (heard.has("refused")) {
      told.add(new ChatEvent.Misunderstood(heard.path("refused").asText(), List.of()));
    }
    return told;
  }
}
