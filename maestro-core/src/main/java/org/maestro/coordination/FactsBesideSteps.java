package org.maestro.coordination;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.knowledge.Snapshot;
import org.maestro.planning.Step;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * What is known, with the things that steps under way are handling as they were when these steps
 * began. While a robot grasps a cup, a camera loses sight of it: that is the step at work, not
 * news. The step's own report will say how it ended.
 */
final class FactsBesideSteps implements Facts {
  private final Snapshot now;
  private final List<Handled> handled = new ArrayList<>();

  private record Handled(Set<String> changed, Set<Term> things, Snapshot before) {
    boolean covers(String name, List<Term> arguments) {
      return changed.contains(name) && arguments.stream().anyMatch(things::contains);
    }
  }

  FactsBesideSteps(Snapshot now) {
    this.now = now;
  }

  /** The step is under way since the given moment. */
  void add(Step step, Snapshot before) {
    Set<Term> things = new HashSet<>();
    things.add(new Term.Name(step.member()));
    step.feature().inputs().stream()
        .map(input -> step.bindings().get(input.name()))
        .filter(Term.Name.class::isInstance)
        .forEach(things::add);
    handled.add(new Handled(Symbols.changedBy(step.feature().effect()), things, before));
  }

  private Snapshot source(String name, List<Term> arguments) {
    return handled.stream()
        .filter(h -> h.covers(name, arguments))
        .map(Handled::before)
        .findFirst()
        .orElse(now);
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    return source(atom.predicate(), atom.arguments()).truth(atom);
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    return source(fluent.name(), fluent.arguments()).number(fluent);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return now.individuals(className);
  }
}
