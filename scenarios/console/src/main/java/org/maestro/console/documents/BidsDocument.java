package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import java.util.OptionalInt;
import org.maestro.agents.content.Words;

/** The answers of all who were asked when a plan was made, step by step. */
public final class BidsDocument {
  private BidsDocument() {}

  /**
   * @param plan its number; empty: the latest
   * @param lines an answer each, as the coordinator tells of them
   */
  public static JsonNode of(String goal, OptionalInt plan, List<Words> lines) {
    JsonMembers document = JsonMembers.empty().text("goal", goal).number("plan", plan);
    ArrayNode bids = document.node().putArray("bids");
    for (Words words : lines) {
      JsonMembers.in(bids)
          .number("step", step(words))
          .text("member", words.string("member"))
          .text("feature", words.string("feature"))
          .text("answer", words.string("answer"))
          .number("cost", words, "cost")
          .number("duration_s", words, "seconds")
          .text("reason", words.string("reason"))
          .truth("chosen", words.string("chosen").filter("true"::equals).isPresent());
    }
    return document.node();
  }

  private static OptionalInt step(Words words) {
    return words.term("step").isPresent()
        ? OptionalInt.of((int) words.number("step", 0))
        : OptionalInt.empty();
  }
}
