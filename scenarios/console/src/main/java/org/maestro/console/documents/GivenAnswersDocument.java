package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.maestro.coordination.api.GivenAnswer;

/** What people have answered to questions of scripts (ADE, 3.3; A45). */
public final class GivenAnswersDocument {
  private static final List<String> COLUMNS =
      List.of("at", "person", "question", "answer", "script", "goal", "part", "to", "by");

  private GivenAnswersDocument() {}

  /**
   * @param answers that are told, oldest first
   * @param leftOut how many more there are that are not told who asks
   */
  public static ObjectNode of(List<GivenAnswer> answers, int leftOut) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode rows = document.node().putArray("answers");
    for (GivenAnswer answer : answers) {
      JsonMembers.in(rows)
          .text("at", answer.at().toString())
          .text("script", answer.script())
          .node()
          .put("goal", answer.goal())
          .put("part", answer.part())
          .put("to", answer.to())
          .put("person", ShownText.of(answer.person()))
          .put("by", ShownText.of(answer.by().caller()))
          .put("question", ShownText.of(answer.question()))
          .put("answer", ShownText.of(answer.answer()));
    }
    document.node().put("left_out", leftOut);
    return document.node();
  }

  /** The same for programs that calculate with them, a record for each answer. */
  public static String csv(JsonNode document) {
    return Csv.of(COLUMNS, document.path("answers"));
  }
}
