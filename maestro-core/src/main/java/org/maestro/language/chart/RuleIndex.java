package org.maestro.language.chart;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.grammar.Rule;
import org.maestro.language.grammar.Symbol;

/** The rules of a grammar by what they begin with, and what may begin a category. Immutable. */
public final class RuleIndex {
  private final Map<Symbol, List<Rule>> byFirst = new HashMap<>();
  private final Map<String, List<Rule>> byCategory = new HashMap<>();
  private final Map<String, Set<String>> leftCorners = new HashMap<>();
  private final Map<String, Set<String>> firstWords = new HashMap<>();

  public RuleIndex(Grammar grammar) {
    Map<String, Set<String>> firsts = new HashMap<>();
    for (Rule rule : grammar.rules()) {
      Symbol first = rule.symbols().get(0);
      byFirst.computeIfAbsent(first, f -> new ArrayList<>()).add(rule);
      byCategory.computeIfAbsent(rule.category(), c -> new ArrayList<>()).add(rule);
      if (first instanceof Symbol.Category category) {
        firsts.computeIfAbsent(rule.category(), c -> new HashSet<>()).add(category.name());
      } else {
        firstWords
            .computeIfAbsent(rule.category(), c -> new HashSet<>())
            .add(((Symbol.Word) first).text());
      }
    }
    Set<String> all = new HashSet<>();
    grammar
        .rules()
        .forEach(
            rule -> {
              all.add(rule.category());
              rule.symbols().stream()
                  .filter(Symbol.Category.class::isInstance)
                  .forEach(symbol -> all.add(((Symbol.Category) symbol).name()));
            });
    all.forEach(category -> leftCorners.put(category, closure(category, firsts)));
  }

  private static Set<String> closure(String category, Map<String, Set<String>> firsts) {
    Set<String> reached = new HashSet<>(Set.of(category));
    Deque<String> open = new ArrayDeque<>(reached);
    while (!open.isEmpty()) {
      for (String next : firsts.getOrDefault(open.pop(), Set.of())) {
        if (reached.add(next)) {
          open.push(next);
        }
      }
    }
    return reached;
  }

  /** The rules that begin with this. */
  List<Rule> beginningWith(Symbol symbol) {
    return byFirst.getOrDefault(symbol, List.of());
  }

  /** The rules that make up the category. */
  List<Rule> of(String category) {
    return byCategory.getOrDefault(category, List.of());
  }

  /** The categories with which the category may begin, itself included. */
  Set<String> leftCorners(String category) {
    return leftCorners.getOrDefault(category, Set.of(category));
  }

  /** The words with which rules of the category itself begin. */
  Set<String> firstWords(String category) {
    return firstWords.getOrDefault(category, Set.of());
  }
}
