package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import java.util.OptionalDouble;
import org.maestro.agents.content.Words;

/** What is known of a question: an answer for each binding, and on what it rests. */
public final class AnswersDocument {
  private AnswersDocument() {}

  /**
   * @param answers as the knowledge agent tells them
   */
  public static JsonNode of(List<Words> answers) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode array = document.node().putArray("answers");
    for (Words answer : answers) {
      String truth = answer.string("truth").orElse("unknown");
      JsonMembers row =
          JsonMembers.in(array)
              .text("truth", truth)
              .terms("binding", answer.termsOf("binding"))
              .number("age_s", answer, "age");
      if (truth.equals("unknown")) {
        row.number("confidence", OptionalDouble.empty());
      } else {
        row.number("confidence", answer, "confidence");
      }
      row.text("source", answer.find("because").flatMap(because -> because.string("source")));
      ArrayNode because = row.node().putArray("because");
      answer.all().stream()
          .filter(part -> part.name().equals("because"))
          .map(Words::of)
          .forEach(belief -> add(because, belief));
    }
    return document.node();
  }

  /**
   * On whose word one of its answers rests, in words; "" when on nobody's.
   *
   * @param answer of such a document
   */
  public static String origin(JsonNode answer) {
    String source = answer.path("source").isTextual() ? answer.path("source").asText() : "";
    return standsInHome(answer) ? source + ", since the platform began" : source;
  }

  /** Whether an answer rests on nothing but what stands in the home. */
  public static boolean standsInHome(JsonNode answer) {
    return answer.path("because").path(0).path("kind").asText().equals("described");
  }

  private static void add(ArrayNode beliefs, Words belief) {
    JsonMembers.in(beliefs)
        .text("fact", belief.string("fact"))
        .text("source", belief.string("source"))
        .text("kind", belief.string("kind"))
        .text("since", belief.string("since"))
        .number("age_s", belief, "age")
        .number("confidence", belief, "confidence");
  }
}
