package org.maestro.language.chart;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.Rule;
import org.maestro.language.grammar.Symbol;

/**
 * The rules by which a reading came about, found again by what the chart has kept of its parts.
 * Bound to one chart.
 */
final class Ancestry {
  /** Rules that stand for each other are followed no further. */
  private static final int DEEPEST = 60;

  private final List<Column> columns;
  private final List<String> words;
  private final RuleIndex rules;
  private final Set<Rule> found = new LinkedHashSet<>();

  /** A part of which the rules are wanted. */
  private record Part(String category, int from, int to, Form form, int penalty) {}

  Ancestry(List<Column> columns, List<String> words, RuleIndex rules) {
    this.columns = columns;
    this.words = words;
    this.rules = rules;
  }

  /** The rules of a reading of all words. */
  Set<Rule> of(Reading reading) {
    find(new Part(Grammar.START, 0, words.size(), reading.form(), reading.penalty()), 0);
    return Set.copyOf(found);
  }

  /** What no rule makes so is an entry of the lexicon. */
  private void find(Part part, int depth) {
    if (depth > DEEPEST) {
      return;
    }
    for (Rule rule : rules.of(part.category())) {
      if (goesOn(part, Derivation.begun(rule, part.from()), part.from(), List.of(), depth)) {
        found.add(rule);
        return;
      }
    }
  }

  private boolean goesOn(Part whole, Derivation begun, int at, List<Part> parts, int depth) {
    if (begun.isComplete()) {
      boolean isIt =
          at == whole.to()
              && begun.penalty() == whole.penalty()
              && begun.form().equals(whole.form())
              && !parts.contains(whole);
      if (isIt) {
        parts.forEach(part -> find(part, depth + 1));
      }
      return isIt;
    }
    if (begun.awaited() instanceof Symbol.Word word) {
      return at < whole.to()
          && words.get(at).equals(word.text())
          && goesOn(whole, begun.advanced(Form.leaf(word.text()), 0), at + 1, parts, depth);
    }
    String category = ((Symbol.Category) begun.awaited()).name();
    for (int end = whole.to(); end > at; end--) {
      for (Reading reading : columns.get(end).readings(category, at)) {
        List<Part> more = new ArrayList<>(parts);
        more.add(new Part(category, at, end, reading.form(), reading.penalty()));
        if (goesOn(whole, begun.advanced(reading.form(), reading.penalty()), end, more, depth)) {
          return true;
        }
      }
    }
    return false;
  }
}
