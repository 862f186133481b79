package org.maestro.language.chart;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.language.grammar.Form;
import org.maestro.language.grammar.Rule;
import org.maestro.language.grammar.Symbol;

/** What is known after a word: rules that go on here, and categories that end here. */
final class Column {
  /** So many derivations of the same part are kept: the usual ones. */
  private static final int KEPT = 16;

  /** So many readings of parts that end with the same word are looked at: nobody means more. */
  private static final int MOST = 500;

  private final Map<Symbol, List<Derivation>> awaiting = new HashMap<>();
  private final Map<Part, List<Reading>> complete = new HashMap<>();

  /** By rule, each of which there is once: to hold two of them against each other takes long. */
  private final IdentityHashMap<Rule, Map<Place, Integer>> kept = new IdentityHashMap<>();

  private final Set<String> predicted = new HashSet<>();
  private final RuleIndex rules;
  private int taken;

  /** A category that began in a column and ends here. */
  record Part(String category, int origin) {}

  /** How far a rule came, and where it began. */
  private record Place(int dot, int origin) {}

  Column(RuleIndex rules) {
    this.rules = rules;
  }

  void predict(String category) {
    if (!predicted.contains(category)) {
      predicted.addAll(rules.leftCorners(category));
    }
  }

  boolean predicts(String category) {
    return predicted.contains(category);
  }

  Set<String> predicted() {
    return predicted;
  }

  /** Notes a rule that goes on here; false when there are enough of them. */
  boolean add(Derivation derivation) {
    Place place = new Place(derivation.dot(), derivation.origin());
    Map<Place, Integer> ofRule = kept.computeIfAbsent(derivation.rule(), rule -> new HashMap<>());
    if (ofRule.merge(place, 1, Integer::sum) > KEPT) {
      return false;
    }
    Symbol awaited = derivation.awaited();
    awaiting.computeIfAbsent(awaited, a -> new ArrayList<>()).add(derivation);
    if (awaited instanceof Symbol.Category category) {
      predict(category.name());
    }
    return true;
  }

  /** Notes what a category means that ends here; false when that is known, or there are enough. */
  boolean add(Part part, Form form, int penalty) {
    if (taken >= MOST) {
      return false;
    }
    List<Reading> readings = complete.computeIfAbsent(part, p -> new ArrayList<>());
    if (readings.stream().anyMatch(one -> one.form().equals(form) && one.penalty() <= penalty)) {
      return false;
    }
    if (readings.size() >= KEPT) {
      Reading worst = Collections.max(readings, Comparator.comparingInt(Reading::penalty));
      if (worst.penalty() <= penalty) {
        return false;
      }
      readings.remove(worst);
    }
    taken++;
    readings.add(new Reading(form, penalty));
    return true;
  }

  List<Derivation> awaiting(Symbol symbol) {
    return awaiting.getOrDefault(symbol, List.of());
  }

  List<Derivation> all() {
    return awaiting.values().stream().flatMap(List::stream).toList();
  }

  Set<Symbol> awaited() {
    return awaiting.keySet();
  }

  List<Reading> readings(String category, int origin) {
    return complete.getOrDefault(new Part(category, origin), List.of());
  }

  boolean isEmpty() {
    return awaiting.isEmpty() && complete.isEmpty();
  }
}
