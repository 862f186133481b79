package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.maestro.language.wording.AnswerWords;
import org.maestro.sl.Truth;

/** What is known of a question, as sentences are made of it. */
final class FoundAnswers {
  private FoundAnswers() {}

  /**
   * @param document as the question of knowledge is answered
   */
  static List<AnswerWords.Found> of(JsonNode document) {
    List<AnswerWords.Found> found = new ArrayList<>();
    for (JsonNode answer : document.path("answers")) {
      Map<String, String> binding = new LinkedHashMap<>();
      answer
          .path("binding")
          .properties()
          .forEach(one -> binding.put(one.getKey(), one.getValue().asText()));
      found.add(
          AnswerWords.Found.of(
              Truth.valueOf(answer.path("truth").asText("unknown").toUpperCase(Locale.ROOT)),
              binding,
              answer.path("because").path(0).path("kind").asText(),
              answer.path("age_s").isNumber()
                  ? OptionalDouble.of(answer.path("age_s").asDouble())
                  : OptionalDouble.empty(),
              answer.path("confidence").asDouble(1)));
    }
    return found;
  }
}
