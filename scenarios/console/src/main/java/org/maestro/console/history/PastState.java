package org.maestro.console.history;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.NullNode;
import com.fasterxml.jackson.databind.node.ObjectNode;

/**
 * What was so: the home, facts, goals and agents after all entries that were taken, in their order.
 * Not thread-safe.
 */
final class PastState {
  private final Table facts = new Table(row -> row.path("fact").asText());

  /** What was known last under a word of a thing, and then not any more. */
  private final Table former =
      new Table(row -> row.path("word").asText() + " " + row.path("arguments").path(0));

  private final Table goals = new Table(row -> row.path("id").asText());

  /** A member that is refused has no agent. */
  private final Table agents =
      new Table(
          row ->
              row.path("agent").isTextual()
                  ? row.path("agent").asText()
                  : row.path("members").toString());

  private JsonNode home = NullNode.getInstance();

  Table facts() {
    return facts;
  }

  Table goals() {
    return goals;
  }

  Table agents() {
    return agents;
  }

  void take(Entry entry) {
    JsonNode told = entry.told();
    double clock = entry.clock();
    switch (entry.kind()) {
      case STATE -> takeAll(told, clock);
      case HOME -> home = told;
      case FACTS -> takeFacts(told, clock);
      case GOALS -> goals.take(told, clock);
      case AGENTS -> agents.take(told, clock);
      case HAPPENING, FIGURES -> {
        // They change nothing of what is so.
      }
    }
  }

  private void takeAll(JsonNode told, double clock) {
    home = told.path("home");
    facts.replace(told.path("facts"), clock);
    former.replace(told.path("former"), clock);
    goals.replace(told.path("goals"), clock);
    agents.replace(told.path("agents"), clock);
  }

  /** What is known not to be so is not shown when that is forgotten. */
  private void takeFacts(JsonNode told, double clock) {
    for (JsonNode name : told.path("gone")) {
      facts
          .find(name.asText())
          .filter(fact -> !fact.path("value").equals(JsonNodeFactory.instance.booleanNode(false)))
          .ifPresent(fact -> former.adopt(facts, name.asText()));
    }
    facts.take(told, clock);
  }

  /** All of it, with the ages of then. */
  ObjectNode document(double clock) {
    ObjectNode document = JsonNodeFactory.instance.objectNode();
    document.set("home", home);
    document.set("facts", facts.rows(clock));
    document.set("former", former.rows(clock));
    document.set("goals", goals.rows(clock));
    document.set("agents", agents.rows(clock));
    return document;
  }
}
