package org.maestro.planning.explanation;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningResult.Obstacle.Kind;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.api.Unavailable;
import org.maestro.planning.grounding.Returned;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Formula.Relation;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The world as it would be if obstacles were overcome. */
public final class Cures {
  /** Strict comparisons are met by that much. */
  private static final double BEYOND = 0.001;

  private Cures() {}

  /** The same task in a world in which these obstacles are none. */
  public static PlanningTask applied(PlanningTask task, List<Obstacle> overcome) {
    Set<String> back = new HashSet<>();
    overcome.stream()
        .filter(obstacle -> obstacle.kind() == Kind.MEMBER)
        .forEach(obstacle -> back.add(obstacle.condition()));
    List<Unavailable> returning =
        task.unavailable().stream().filter(m -> back.contains(m.feature().member())).toList();
    Changed facts =
        new Changed(new Returned(task.facts(), task.vocabulary(), returning), task.vocabulary());
    List<PricedFeature> features = new ArrayList<>(task.features());
    List<Unavailable> unavailable = new ArrayList<>(task.unavailable());
    Set<StepKey> barred = new HashSet<>(task.barred());
    for (Obstacle obstacle : overcome) {
      if (obstacle.kind() == Kind.STEP) {
        barred.removeAll(obstacle.subject().map(Set::of).orElse(Set.of()));
      } else if (obstacle.kind() != Kind.MEMBER) {
        facts.make(obstacle);
      }
    }
    returning.forEach(missing -> features.add(missing.feature()));
    unavailable.removeAll(returning);
    return task.withFacts(facts)
        .withFeatures(features)
        .withBarred(barred)
        .withUnavailable(unavailable, task.whyBarred());
  }

  /** Facts with some of them made otherwise. */
  private static final class Changed implements Facts {
    private final Facts before;
    private final Vocabulary vocabulary;
    private final Map<Formula.Atom, Boolean> truths = new LinkedHashMap<>();
    private final Map<Expression.Fluent, Double> numbers = new HashMap<>();

    Changed(Facts before, Vocabulary vocabulary) {
      this.before = before;
      this.vocabulary = vocabulary;
    }

    void make(Obstacle obstacle) {
      make(SlParser.formula(obstacle.condition(), vocabulary::isFluent), true, obstacle);
    }

    private void make(Formula formula, boolean positive, Obstacle obstacle) {
      if (formula instanceof Formula.Not not) {
        make(not.operand(), !positive, obstacle);
      } else if (formula instanceof Formula.And and) {
        and.operands().forEach(part -> make(part, positive, obstacle));
      } else if (formula instanceof Formula.Atom atom) {
        truths.put(atom, positive);
      } else if (formula instanceof Formula.UnknownNumber unknown && !positive) {
        numbers.put(unknown.fluent(), 0.0);
      } else if (formula instanceof Formula.Comparison comparison) {
        compare(comparison, positive, obstacle.missing());
      }
    }

    private void compare(Formula.Comparison comparison, boolean positive, OptionalDouble missing) {
      OptionalDouble left = value(comparison.left());
      OptionalDouble right = value(comparison.right());
      boolean more =
          (comparison.relation() == Relation.AT_LEAST || comparison.relation() == Relation.GREATER)
              == positive;
      double beyond =
          comparison.relation() == Relation.LESS || comparison.relation() == Relation.GREATER
              ? BEYOND
              : 0;
      if (comparison.left() instanceof Expression.Fluent fluent
          && !(comparison.right() instanceof Expression.Fluent)) {
        double target =
            left.isPresent() && missing.isPresent()
                ? left.getAsDouble() + (more ? 1 : -1) * missing.getAsDouble()
                : right.orElse(0);
        numbers.put(fluent, target + (more ? beyond : -beyond));
      } else if (comparison.right() instanceof Expression.Fluent fluent) {
        numbers.put(fluent, left.orElse(0) - (more ? beyond : -beyond));
        if (left.isEmpty() && comparison.left() instanceof Expression.Fluent other) {
          numbers.put(other, right.orElse(0));
          right.ifPresent(known -> numbers.put(fluent, known));
        }
      }
    }

    private OptionalDouble value(Expression expression) {
      if (expression instanceof Expression.Fluent fluent) {
        return number(fluent);
      }
      return expression instanceof Expression.OfTerm ofTerm
              && ofTerm.term() instanceof Term.Number number
          ? OptionalDouble.of(number.value())
          : OptionalDouble.empty();
    }

    @Override
    public Truth truth(Formula.Atom atom) {
      PredicateDeclaration declared = vocabulary.predicates().get(atom.predicate());
      if (declared != null && declared.derivedWhen().isPresent()) {
        Map<String, Term> bindings = new HashMap<>();
        for (int i = 0; i < Math.min(atom.arguments().size(), declared.parameters().size()); i++) {
          bindings.put(declared.parameters().get(i).name(), atom.arguments().get(i));
        }
        Truth truth = new Evaluation(this).truth(declared.derivedWhen().get(), bindings);
        return declared.observable() ? truth : Truth.of(truth == Truth.TRUE);
      }
      Boolean made = truths.get(atom);
      if (made == null && declared != null && declared.symmetric()) {
        made =
            truths.get(
                new Formula.Atom(
                    atom.predicate(), List.of(atom.arguments().get(1), atom.arguments().get(0))));
      }
      if (made != null) {
        return Truth.of(made);
      }
      boolean hasOtherValue =
          declared != null
              && declared.functional()
              && truths.entrySet().stream()
                  .anyMatch(e -> e.getValue() && isSameVariable(e.getKey(), atom));
      return hasOtherValue ? Truth.FALSE : before.truth(atom);
    }

    private static boolean isSameVariable(Formula.Atom a, Formula.Atom b) {
      int last = a.arguments().size() - 1;
      return a.predicate().equals(b.predicate())
          && a.arguments().subList(0, last).equals(b.arguments().subList(0, last));
    }

    @Override
    public OptionalDouble number(Expression.Fluent fluent) {
      Double made = numbers.get(fluent);
      return made == null ? before.number(fluent) : OptionalDouble.of(made);
    }

    @Override
    public double chanceStill(Formula.Atom atom) {
      return before.chanceStill(atom);
    }

    @Override
    public Collection<Term.Name> individuals(String className) {
      return before.individuals(className);
    }
  }
}
