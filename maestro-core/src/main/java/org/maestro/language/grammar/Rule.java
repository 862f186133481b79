package org.maestro.language.grammar;

import java.util.List;

/**
 * A rule: a category is made of symbols in this order, and means what the template says of what
 * they mean.
 *
 * @param labels by which the template calls what a symbol means, in the same order; "" for none
 * @param penalty 0 for usual wordings; of several readings the one with fewer is preferred
 * @param line of its grammar; that of the pattern where a construction filled it
 */
public record Rule(
    String category,
    List<Symbol> symbols,
    List<String> labels,
    Template template,
    int penalty,
    int line) {
  public Rule {
    symbols = List.copyOf(symbols);
    labels = List.copyOf(labels);
  }
}
