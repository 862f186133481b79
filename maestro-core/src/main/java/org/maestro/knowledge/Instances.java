package org.maestro.knowledge;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Candidates;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** For which individuals a condition is known to hold. Immutable; any thread may ask. */
public final class Instances {
  private final Formula condition;
  private final Snapshot now;
  private final Candidates candidates;

  public Instances(Formula condition, Snapshot now) {
    this.condition = condition;
    this.now = now;
    this.candidates = new Candidates(now::candidates);
  }

  /** The condition as it holds, without variables, and what it has in their places. */
  public Map<Formula, Substitution> all() {
    List<Map<String, Term>> bindings = List.of(Map.of());
    Evaluation known = new Evaluation(now);
    Set<String> bound = new HashSet<>();
    for (String variable : FreeVariables.of(condition)) {
      bound.add(variable);
      List<Formula> decided = decided(variable, bound);
      List<Map<String, Term>> extended = new ArrayList<>();
      for (Map<String, Term> binding : bindings) {
        for (Term.Name individual : individuals(variable, binding)) {
          Map<String, Term> with = new HashMap<>(binding);
          with.put(variable, individual);
          if (decided.stream().allMatch(part -> known.truth(part, with) == Truth.TRUE)) {
            extended.add(with);
          }
        }
      }
      bindings = extended;
    }
    Map<Formula, Substitution> instances = new LinkedHashMap<>();
    for (Map<String, Term> binding : bindings) {
      if (known.truth(condition, binding) == Truth.TRUE) {
        Substitution instance = new Substitution(binding);
        instances.put(instance.apply(condition), instance);
      }
    }
    return instances;
  }

  /** The parts that have to hold, and of which this is the last variable. */
  private List<Formula> decided(String variable, Set<String> bound) {
    return condition instanceof Formula.And and
        ? and.operands().stream()
            .filter(part -> FreeVariables.of(part).contains(variable))
            .filter(part -> bound.containsAll(FreeVariables.of(part)))
            .toList()
        : List.of();
  }

  private List<Term.Name> individuals(String variable, Map<String, Term> binding) {
    Optional<Set<Term>> among = candidates.of(condition, true, variable, binding);
    return now.individuals("").stream()
        .filter(individual -> among.isEmpty() || among.get().contains(individual))
        .toList();
  }

  /** Of one that has no variables. */
  public Truth truth(Formula instance) {
    return new Evaluation(now).truth(instance, Map.of());
  }
}
