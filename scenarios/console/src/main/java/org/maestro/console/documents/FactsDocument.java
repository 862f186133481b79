package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.sl.Fact;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** All that is known, each fact taken apart. */
public final class FactsDocument {
  private FactsDocument() {}

  /**
   * @param rights of whom it is for; of what is kept from her is told how much that is
   */
  public static JsonNode of(Snapshot snapshot, ReadingRights rights) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode facts = document.node().putArray("facts");
    List<Belief> all = snapshot.beliefs();
    List<Belief> told = all.stream().filter(belief -> rights.mayReadFact(belief.fact())).toList();
    told.forEach(belief -> add(JsonMembers.in(facts), belief, snapshot));
    return document.number("left_out", OptionalInt.of(all.size() - told.size())).node();
  }

  /** One fact by itself. */
  public static JsonNode of(Belief belief, Snapshot snapshot) {
    return add(JsonMembers.empty(), belief, snapshot).node();
  }

  /** What one says, without who says so. */
  public static JsonNode parts(String fact) {
    return parts(JsonMembers.empty(), fact).node();
  }

  static JsonMembers add(JsonMembers row, Belief belief, Snapshot snapshot) {
    return parts(row, belief.fact())
        .text("source", belief.source().agent())
        .text("kind", belief.source().kind().name().toLowerCase(Locale.ROOT))
        .text("since", belief.since().toString())
        .number("age_s", belief.age(snapshot.at()).toMillis() / 1000.0)
        .number("confidence", belief.confidence());
  }

  private static JsonMembers parts(JsonMembers row, String text) {
    row.text("fact", text);
    Fact fact = SlParser.fact(text);
    if (fact instanceof Fact.Equation equation) {
      parts(row, equation.fluent().name(), equation.fluent().arguments());
      row.node().set("value", JsonMembers.value(equation.value()));
    } else if (fact instanceof Fact.Holds holds) {
      parts(row, holds.atom().predicate(), holds.atom().arguments());
      row.truth("value", true);
    } else if (fact instanceof Fact.Excluded excluded) {
      parts(row, excluded.atom().predicate(), excluded.atom().arguments());
      row.truth("value", false);
    } else if (fact instanceof Fact.Unknown unknown) {
      parts(row, unknown.atom().predicate(), unknown.atom().arguments());
      row.node().putNull("value");
    }
    return row;
  }

  private static void parts(JsonMembers row, String word, List<Term> arguments) {
    row.text("word", word).terms("arguments", arguments);
  }
}
