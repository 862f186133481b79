package org.maestro.planning.explanation;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.planning.api.Effort;
import org.maestro.planning.api.PlanningResult.Obstacle.Kind;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.optimal.LandmarkCut;
import org.maestro.planning.optimal.OptimalSearch;
import org.maestro.planning.optimal.Pruning;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.Condition.Constant;
import org.maestro.planning.problem.GroundGoal;
import org.maestro.planning.problem.GroundGoal.Alternative;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.StaticFacts;
import org.maestro.planning.problem.StepPrice;
import org.maestro.planning.problem.Variable;
import org.maestro.planning.settings.Threshold;
import org.maestro.sl.Effect.Assignment;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Finds the least set of conditions with which a goal could be reached, by planning: to each
 * condition that may be assumed there is one more operator, which brings it about for good and is
 * dearer than any plan. As the plan found is a cheapest one, no assumption in it is superfluous.
 */
final class ExcuseSearch {
  /** Any assumption weighs more than any number of steps. */
  private static final double ASSUMPTION = 1e5;

  private static final String FLAG = "$assumed";

  private final GroundProblem base;
  private final PricedFeature anyFeature;
  private final Effort effort;

  /**
   * @param anyFeature of those that are offered: operators that assume something bear its name
   * @param effort of all searches together: an explanation that comes late helps nobody, and others
   *     wait for plans meanwhile
   */
  ExcuseSearch(GroundProblem base, PricedFeature anyFeature, Effort effort) {
    this.base = base;
    this.anyFeature = anyFeature;
    this.effort = effort;
  }

  /** The result of the search: excuses, none that would do, or neither. */
  sealed interface Outcome {
    /**
     * @param neededBy for each assumed condition the step that needs it; empty: the goal
     */
    record Found(Map<Condition, Optional<StepKey>> neededBy) implements Outcome {}

    /** Nothing that may be assumed would do. */
    record Nothing() implements Outcome {}

    record BrokenOff() implements Outcome {}
  }

  /**
   * @param weights of what may be assumed
   * @param given what is taken to hold for nothing
   */
  Outcome run(Map<Condition, Double> weights, Set<Condition> given) {
    Map<Condition, Double> paidPerUse = new LinkedHashMap<>(weights);
    paidPerUse.keySet().removeIf(leaf -> !isOfOneSetting(leaf));
    Map<Condition, Condition> flags = new LinkedHashMap<>();
    List<Operator> operators = new ArrayList<>();
    weights.forEach(
        (leaf, weight) -> {
          if (!paidPerUse.containsKey(leaf)) {
            Variable flag = flag(flags.size());
            flags.put(leaf, new Condition.Literal(flag, 0, Condition.Question.IS));
            operators.add(assumption(flag, weight));
          }
        });
    Map<Condition, Condition> replacements = new LinkedHashMap<>();
    flags.keySet().forEach(leaf -> replacements.put(leaf, weakened(leaf, flags, given)));
    paidPerUse.keySet().forEach(leaf -> replacements.put(leaf, Constant.TRUE));
    given.forEach(leaf -> replacements.put(leaf, Constant.TRUE));
    Map<StepKey, Condition> paidBy = new LinkedHashMap<>();
    for (Operator operator : base.operators()) {
      Operator freed = operator.withPrecondition(replaced(operator.precondition(), replacements));
      for (Condition leaf : operator.precondition().conjuncts()) {
        if (paidPerUse.containsKey(leaf)) {
          freed = dearer(freed, paidPerUse.get(leaf));
          paidBy.put(operator.key(), leaf);
        }
      }
      operators.add(freed);
    }
    GroundGoal goal =
        new GroundGoal(
            base.goal().alternatives().stream()
                .map(a -> new Alternative(a.binding(), replaced(a.condition(), replacements)))
                .toList());
    GroundProblem problem =
        new GroundProblem(operators, goal, base.variables(), base.numbers(), base.initial())
            .with(operators);
    Pruning.Pruned pruned = Pruning.pruned(problem);
    if (!pruned.isSolvable()) {
      return new Outcome.Nothing();
    }
    OptimalSearch.Outcome outcome =
        new OptimalSearch(
                pruned.problem(),
                new LandmarkCut(pruned.relaxed()),
                effort,
                Double.POSITIVE_INFINITY)
            .run();
    if (outcome instanceof OptimalSearch.Outcome.Found found) {
      Map<Condition, Optional<StepKey>> assumed = assumed(found.operators(), flags);
      for (Operator operator : found.operators()) {
        if (paidBy.containsKey(operator.key())) {
          assumed.put(paidBy.get(operator.key()), Optional.of(operator.key()));
        }
      }
      return new Outcome.Found(assumed);
    }
    return outcome instanceof OptimalSearch.Outcome.Exhausted
        ? new Outcome.Nothing()
        : new Outcome.BrokenOff();
  }

  /**
   * Whether the condition is that a member is there which does nothing but set one number. Its
   * absence is paid for with each use, so that bounds for sums of settings know of it.
   */
  private boolean isOfOneSetting(Condition leaf) {
    if (!(leaf instanceof Condition.Fixed fixed) || fixed.obstacle().kind() != Kind.MEMBER) {
      return false;
    }
    Set<Object> assigned = new LinkedHashSet<>();
    for (Operator operator : base.operators()) {
      if (operator.precondition().conjuncts().contains(leaf)) {
        List<Object> here =
            operator.changes().stream()
                .filter(c -> c instanceof Change.Adjust a && a.assignment() == Assignment.ASSIGN)
                .map(Change::target)
                .toList();
        if (here.size() != 1) {
          return false;
        }
        assigned.addAll(here);
      }
    }
    return assigned.size() == 1;
  }

  private static Operator dearer(Operator operator, double weight) {
    StepPrice price = operator.price();
    NumberExpression sum =
        new NumberExpression.Operation(
            Expression.Operator.PLUS,
            List.of(price.cost(), new NumberExpression.Constant(weight * ASSUMPTION)));
    NumberExpression cost =
        price.cost().isConstant()
            ? new NumberExpression.Constant(sum.value(new NumberVector(new double[0])))
            : sum;
    return operator.withPrice(new StepPrice(cost, price.seconds(), price.exact()));
  }

  /** What reaches a higher threshold of a number reaches the lower ones too. */
  private static Condition weakened(
      Condition leaf, Map<Condition, Condition> flags, Set<Condition> given) {
    List<Condition> alternatives = new ArrayList<>();
    alternatives.add(leaf);
    alternatives.add(flags.get(leaf));
    flags.forEach(
        (other, flag) -> {
          if (implies(other, leaf)) {
            alternatives.add(flag);
          }
        });
    return given.stream().anyMatch(other -> implies(other, leaf))
        ? Constant.TRUE
        : Condition.any(alternatives);
  }

  private static boolean implies(Condition stronger, Condition weaker) {
    if (!(stronger instanceof Condition.Compare a) || !(weaker instanceof Condition.Compare b)) {
      return false;
    }
    Optional<Threshold> high = Threshold.of(a);
    Optional<Threshold> low = Threshold.of(b);
    return high.isPresent() && low.isPresent() && isHigher(high.get(), low.get());
  }

  private static boolean isHigher(Threshold high, Threshold low) {
    return high.variable() == low.variable()
        && high.upward() == low.upward()
        && (high.upward() ? high.bound() > low.bound() : high.bound() < low.bound());
  }

  private static Condition replaced(Condition condition, Map<Condition, Condition> replacements) {
    if (condition instanceof Condition.All all) {
      return Condition.all(all.parts().stream().map(p -> replaced(p, replacements)).toList());
    } else if (condition instanceof Condition.Any any) {
      return Condition.any(any.parts().stream().map(p -> replaced(p, replacements)).toList());
    }
    return replacements.getOrDefault(condition, condition);
  }

  /** The plan's assumptions, told by the flags that its operators put. */
  private static Map<Condition, Optional<StepKey>> assumed(
      List<Operator> plan, Map<Condition, Condition> flags) {
    Map<Condition, Optional<StepKey>> neededBy = new LinkedHashMap<>();
    flags.forEach(
        (leaf, flag) -> {
          Variable variable = ((Condition.Literal) flag).variable();
          if (plan.stream()
              .anyMatch(o -> o.changes().stream().anyMatch(c -> c.target() == variable))) {
            neededBy.put(leaf, firstThatReads(variable, plan));
          }
        });
    return neededBy;
  }

  private static Optional<StepKey> firstThatReads(Variable flag, List<Operator> plan) {
    for (Operator operator : plan) {
      boolean[] reads = new boolean[1];
      operator
          .precondition()
          .forEachLeaf(
              leaf ->
                  reads[0] |=
                      leaf instanceof Condition.Literal literal && literal.variable() == flag);
      if (reads[0]) {
        return Optional.of(operator.key());
      }
    }
    return Optional.empty();
  }

  private static Variable flag(int number) {
    List<Term> arguments = List.of(new Term.Number(number));
    return new Variable(FLAG, arguments, false, false, new StaticFacts(new NoFacts()), List.of());
  }

  private Operator assumption(Variable flag, double weight) {
    return new Operator(
        anyFeature,
        Map.of(),
        Constant.TRUE,
        List.of(new Change.Put(Constant.TRUE, flag, 0)),
        new StepPrice(
            new NumberExpression.Constant(weight * ASSUMPTION),
            new NumberExpression.Constant(0),
            true));
  }

  /** Facts of which none holds. */
  private record NoFacts() implements Facts {
    @Override
    public Truth truth(Formula.Atom atom) {
      return Truth.FALSE;
    }

    @Override
    public OptionalDouble number(Expression.Fluent fluent) {
      return OptionalDouble.empty();
    }

    @Override
    public List<Term.Name> individuals(String className) {
      return List.of();
    }
  }
}
