package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.maestro.agents.content.Words;
import org.maestro.sl.Term;

/** A platform's goals, in the order in which they were stated. */
public final class GoalsDocument {
  private GoalsDocument() {}

  /**
   * @param lines a goal each, as the coordinator tells of them
   */
  public static JsonNode of(List<Words> lines) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode goals = document.node().putArray("goals");
    for (Words words : lines) {
      List<String> goal = goal(words);
      JsonMembers row =
          JsonMembers.in(goals)
              .text("id", goal.stream().findFirst())
              .text("goal", goal.stream().skip(1).findFirst())
              .text("requester", words.string("requester"))
              .text("state", words.string("state"))
              .text("detail", words.string("detail"));
      row.node().put("priority", (int) words.number("priority", 0));
      row.number("deadline_s", words, "deadline").number("age_s", words, "age");
      ArrayNode waits = row.node().putArray("waits");
      for (List<String> edge : waits(words)) {
        JsonMembers.in(waits).text("for", edge.get(0)).text("holder", edge.get(1));
      }
      words
          .find("worth")
          .ifPresentOrElse(worth -> worth(row, worth), () -> row.node().putNull("worth"));
      words
          .find("stakes")
          .ifPresentOrElse(stakes -> stakes(row, stakes), () -> row.node().putNull("stakes"));
    }
    return document.node();
  }

  private static void worth(JsonMembers row, Words words) {
    row.in("worth")
        .number("chance", words, "chance")
        .number("tried", OptionalInt.of((int) words.number("tried", 0)))
        .number("benefit", words, "benefit")
        .number("cost", words, "cost")
        .number("utility", words, "utility")
        .number("elapsed_s", words, "elapsed")
        .number("allowed_s", words, "allowed")
        .number("urgency_from", words, "from")
        .number("urgency_to", words, "to")
        .number("urgency", words, "urgency")
        .number("weight", words, "priority");
  }

  /** As it can be stated again. */
  private static void stakes(JsonMembers row, Words words) {
    List<Term> urgency = words.find("urgency").map(Words::terms).orElse(List.of());
    row.in("stakes")
        .text("benefit", words.string("benefit"))
        .number("chance", words, "chance")
        .number("allowed_s", words, "allowed")
        .number("urgency_from", number(urgency, 0))
        .number("urgency_to", number(urgency, 1));
  }

  private static OptionalDouble number(List<Term> terms, int at) {
    return terms.size() > at && terms.get(at) instanceof Term.Number number
        ? OptionalDouble.of(number.value())
        : OptionalDouble.empty();
  }

  private static List<String> goal(Words words) {
    return words.strings("goal");
  }

  /** What it waits for, and which goal has that. */
  private static List<List<String>> waits(Words words) {
    return words.find("waits").map(Words::all).orElse(List.of()).stream()
        .map(edge -> Words.of(edge).terms().stream().map(Words::plain).toList())
        .filter(edge -> edge.size() == 2)
        .toList();
  }
}
