package org.maestro.planning.cases;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.maestro.planning.problem.Variable;

/**
 * The facts that may hold where a condition does: where it says which value a variable has, no
 * other value holds and none is open; where it says that a value is open, none is known.
 */
final class FactsBefore {
  private final Map<Object, Clause.Fact> held = new HashMap<>();
  private final Set<Variable> open = new HashSet<>();

  FactsBefore(Clause condition) {
    condition
        .facts()
        .forEach(
            (fact, holds) -> {
              if (holds && fact instanceof Clause.Is is) {
                held.put(is.variable(), fact);
              } else if (holds && fact instanceof Clause.Has has) {
                held.put(has.variable(), fact);
              } else if (holds && fact instanceof Clause.Open unknown) {
                open.add(unknown.variable());
              }
            });
  }

  boolean mayHold(Clause.Fact fact) {
    if (fact instanceof Clause.Is is) {
      Clause.Fact value = held.get(is.variable());
      return value == null ? !open.contains(is.variable()) : value.equals(fact);
    } else if (fact instanceof Clause.Has has) {
      Clause.Fact value = held.get(has.variable());
      return value == null || value.equals(fact);
    }
    return !(fact instanceof Clause.Open unknown && held.containsKey(unknown.variable()));
  }

  /** Of a variable's facts those that may hold, and perhaps others. */
  Set<Clause.Fact> among(Variable variable, Set<Clause.Fact> facts) {
    Clause.Fact value = held.get(variable);
    return value == null ? facts : Set.of(value);
  }
}
