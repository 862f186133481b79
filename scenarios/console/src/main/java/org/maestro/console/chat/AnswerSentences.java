package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.maestro.console.documents.AnswersDocument;

/** What is known of a question, in sentences. */
final class AnswerSentences {
  private static final int MOST = 8;

  private AnswerSentences() {}

  /**
   * @param document as the question of knowledge is answered
   */
  static List<String> of(JsonNode document) {
    List<String> sentences = new ArrayList<>();
    JsonNode answers = document.path("answers");
    for (JsonNode answer : answers) {
      if (sentences.size() < MOST) {
        sentences.add(sentence(answer));
      }
    }
    if (answers.size() > MOST) {
      sentences.add("There are %d answers more.".formatted(answers.size() - MOST));
    }
    return sentences.isEmpty() ? List.of("Nothing is known of that.") : sentences;
  }

  private static String sentence(JsonNode answer) {
    String truth = answer.path("truth").asText();
    if (truth.equals("unknown")) {
      return "Nobody knows.";
    }
    List<String> bound = new ArrayList<>();
    answer
        .path("binding")
        .properties()
        .forEach(one -> bound.add(one.getKey() + " is " + inWords(one.getValue())));
    String what = bound.isEmpty() ? "" : ": " + String.join(", ", bound);
    String source = AnswersDocument.origin(answer);
    String since =
        answer.path("age_s").isNumber() && !AnswersDocument.standsInHome(answer)
            ? String.format(Locale.ROOT, ", %.0f s ago", answer.path("age_s").asDouble())
            : "";
    return (truth.equals("true") ? "Yes" : "No")
        + what
        + (source.isEmpty() ? "" : ", by " + source + since)
        + ".";
  }

  private static String inWords(JsonNode value) {
    if (value.isNumber()) {
      double number = Math.round(value.asDouble() * 100) / 100.0;
      return number == Math.rint(number) ? String.valueOf((long) number) : String.valueOf(number);
    }
    return value.isTextual() ? value.asText() : value.toString();
  }
}
