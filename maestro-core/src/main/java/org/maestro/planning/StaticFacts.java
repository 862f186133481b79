package org.maestro.planning;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The facts of a task; each is asked once, as derived and geometric ones take their time. */
final class StaticFacts {
  private Facts facts;
  private final Map<Formula.Atom, Truth> truths = new HashMap<>();
  private final Map<Expression.Fluent, Double> numbers = new HashMap<>();
  private final Map<String, List<Term>> individuals = new HashMap<>();

  StaticFacts(Facts facts) {
    this.facts = facts;
  }

  /**
   * Takes other facts, provided that all that was asked of what cannot change is so there too.
   *
   * @return the atoms and fluents that may change and are otherwise there; empty when these facts
   *     were not taken
   */
  Optional<Set<Object>> renew(Facts next, Signature signature) {
    Set<Object> changed = new LinkedHashSet<>();
    if (next == facts) {
      return Optional.of(changed);
    }
    StaticFacts fresh = new StaticFacts(next);
    for (Map.Entry<String, List<Term>> asked : individuals.entrySet()) {
      if (!asked.getValue().equals(fresh.individuals(asked.getKey()))) {
        return Optional.empty();
      }
    }
    for (Map.Entry<Formula.Atom, Truth> asked : truths.entrySet()) {
      if (asked.getValue() != fresh.truth(asked.getKey())
          && (!signature.isDynamic(asked.getKey().predicate()) || !changed.add(asked.getKey()))) {
        return Optional.empty();
      }
    }
    for (Map.Entry<Expression.Fluent, Double> asked : numbers.entrySet()) {
      if (Double.compare(asked.getValue(), fresh.number(asked.getKey())) != 0
          && (!signature.isDynamic(asked.getKey().name()) || !changed.add(asked.getKey()))) {
        return Optional.empty();
      }
    }
    facts = next;
    truths.putAll(fresh.truths);
    numbers.putAll(fresh.numbers);
    return Optional.of(changed);
  }

  Truth truth(Formula.Atom atom) {
    Truth known = truths.get(atom);
    if (known == null) {
      known = facts.truth(atom);
      truths.put(atom, known);
    }
    return known;
  }

  /** The number, or {@link Quantity#UNKNOWN}. */
  double number(Expression.Fluent fluent) {
    Double known = numbers.get(fluent);
    if (known == null) {
      double asked = facts.number(fluent).orElse(Quantity.UNKNOWN);
      known = Double.isFinite(asked) ? Quantity.rounded(asked) : Quantity.UNKNOWN;
      numbers.put(fluent, known);
    }
    return known;
  }

  double chanceStill(Formula.Atom atom) {
    return facts.chanceStill(atom);
  }

  /** In the stable order of the facts. */
  List<Term> individuals(String className) {
    List<Term> known = individuals.get(className);
    if (known == null) {
      known = List.copyOf(new ArrayList<Term>(facts.individuals(className)));
      individuals.put(className, known);
    }
    return known;
  }
}
