package org.maestro.planning.sensing;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.optimal.RelaxedProblem;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Quantity;
import org.maestro.planning.problem.Sought;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Successors;
import org.maestro.planning.problem.Variable;

/**
 * Estimates, by plans of the relaxed problem, what a look and all that comes after it cost once
 * other looks were made in vain: the robot has moved, the lamps are on that those looks needed.
 */
final class LookCosts {
  private static final double SAME = 1e-9;

  private final GroundProblem problem;
  private final Sought sought;
  private final RelaxedProblem relaxed;
  private final Map<StepKey, Operator> operatorByKey = new HashMap<>();
  private final RelaxedSums sums;

  /** For each operator the indices of the values at which it looks. */
  private final int[][] looksOf;

  /** For each value the first operator that looks at it. */
  private final int[] firstLook;

  /** Propositions of which a look at first may make others true. */
  private final List<Integer> decided = new ArrayList<>();

  /** From what is true whatever a look finds; null until it is asked for. */
  private @Nullable RelaxedSums whateverIsFound;

  /**
   * The problem's variables are placed for it, and have to stay so while it is asked.
   *
   * @param relaxed of the problem
   */
  LookCosts(GroundProblem problem, RelaxedProblem relaxed, Sought sought) {
    this.problem = problem;
    this.sought = sought;
    this.relaxed = relaxed;
    problem.operators().forEach(operator -> operatorByKey.putIfAbsent(operator.key(), operator));
    this.sums = new RelaxedSums(relaxed);
    this.looksOf = looksOf(problem, sought);
    this.firstLook = new int[sought.values().size()];
    for (int operator = looksOf.length - 1; operator >= 0; operator--) {
      for (int value : looksOf[operator]) {
        firstLook[value] = operator;
      }
    }
  }

  private static int[][] looksOf(GroundProblem problem, Sought sought) {
    Map<Integer, Integer> indices = new HashMap<>();
    sought.values().forEach(value -> indices.put(value, indices.size()));
    return problem.operators().stream()
        .map(
            operator ->
                sought.lookedAt(operator).filter(indices::containsKey).map(indices::get).toArray())
        .toArray(int[][]::new);
  }

  Sought sought() {
    return sought;
  }

  State initial() {
    return problem.initial();
  }

  /** The state after these steps, which end with a look that found what it looked for. */
  State after(List<StepKey> steps) {
    State state = problem.initial();
    for (StepKey key : steps) {
      Operator operator = operatorByKey.get(key);
      if (operator != null && Successors.isApplicable(operator, state)) {
        state = Successors.after(operator, state);
      }
    }
    return state;
  }

  /** The costs of looks at all values; infinite where there is no way. */
  double[] looks(State state) {
    double[] costs = relaxed.costs(state);
    sums.from(relaxed.truths(state), costs, RelaxedSums.ALL);
    double[] least = new double[sought.values().size()];
    Arrays.fill(least, Double.POSITIVE_INFINITY);
    for (RelaxedProblem.Action action : relaxed.actions()) {
      if (action.payer() >= 0 && action.payer() < problem.operators().size()) {
        Operator operator = problem.operators().get(action.payer());
        for (int i : looksOf[action.payer()]) {
          double sum = sums.of(action.preconditions());
          double cost = sum + operator.price().cost(state.numbers());
          least[i] = Double.isNaN(cost) ? least[i] : Math.min(least[i], cost);
        }
      }
    }
    return least;
  }

  /**
   * Which of the places costs least with all that follows when it is found there; the first among
   * equals.
   *
   * @param places indices of values
   */
  int leastOf(List<Integer> places) {
    double[] looks = looks(initial());
    int best = places.get(0);
    double least = Double.POSITIVE_INFINITY;
    for (int place : places) {
      if (looks[place] < least) {
        double cost = looks[place] + restAtOnce(place).cost();
        if (cost < least - SAME) {
          best = place;
          least = cost;
        }
      }
    }
    return best;
  }

  /**
   * The costs of looks in a state in which something was found, as if it had not been found there.
   *
   * @param vain index of the value at which it turned out not to be
   */
  double[] looksAfterVainLook(State found, int vain) {
    Variable variable = sought.variable();
    int[] codes = found.copyOfCodes();
    codes[variable.index()] = variable.without(variable.initialCode(), sought.values().get(vain));
    return looks(new State(codes, found.numbers()));
  }

  /** Whether the goal may be reached without any of the looks. */
  boolean isInReachWithoutLooks() {
    double[] costs = relaxed.costs(problem.initial());
    for (int i = 0; i < looksOf.length; i++) {
      if (looksOf[i].length > 0) {
        costs[i] = Double.POSITIVE_INFINITY;
      }
    }
    return relaxed.reachable(relaxed.truths(problem.initial()), costs)[relaxed.goal()];
  }

  /**
   * The way from a successful look on to the goal.
   *
   * @param before the state before all that the look needs
   * @param look the state after a successful look that began at first, which shows what it changes
   */
  RelaxedSums.Way rest(State before, State look, int found) {
    State state = joined(before, look, found);
    double[] costs = relaxed.costs(state);
    return sums.from(relaxed.truths(state), costs, relaxed.goal()).toGoal();
  }

  /**
   * The way from a successful look on to the goal, where nothing else was done before: as {@link
   * #rest} with the initial state for both, but among ways of the same sum it may be another.
   */
  RelaxedSums.Way restAtOnce(int found) {
    if (whateverIsFound == null) {
      whateverIsFound = whateverIsFound();
    }
    State state = joined(problem.initial(), problem.initial(), found);
    return whateverIsFound.toGoalWith(
        decided.stream().filter(i -> relaxed.leaf(i).holds(state)).toList());
  }

  private RelaxedSums whateverIsFound() {
    Set<Variable> touched = new HashSet<>(Set.of(sought.variable()));
    for (int look : firstLook) {
      Operator operator = problem.operators().get(look);
      literals(operator).forEach(literal -> touched.add(literal.variable()));
      puts(operator).forEach(put -> touched.add(put.variable()));
    }
    State initial = problem.initial();
    boolean[] truths = relaxed.truths(initial);
    for (int i = 0; i < truths.length; i++) {
      if (relaxed.leaf(i) instanceof Condition.Literal literal
          && touched.contains(literal.variable())) {
        decided.add(i);
        truths[i] = false;
      }
    }
    return new RelaxedSums(relaxed).from(truths, relaxed.costs(initial), RelaxedSums.ALL);
  }

  /**
   * What the look changed and brings about, and where the one who looks is, upon the state before.
   */
  private State joined(State before, State look, int found) {
    State first = problem.initial();
    int[] codes = before.copyOfCodes();
    for (Variable variable : problem.variables()) {
      if (look.code(variable) != first.code(variable)) {
        codes[variable.index()] = look.code(variable);
      }
    }
    Operator operator = problem.operators().get(firstLook[found]);
    literals(operator).forEach(literal -> codes[literal.variable().index()] = literal.value());
    puts(operator).forEach(put -> codes[put.variable().index()] = put.value());
    codes[sought.variable().index()] = sought.values().get(found);
    double[] numbers = before.numbers().copy();
    for (NumberVariable number : problem.numbers()) {
      double changed = look.number(number);
      double initial = first.number(number);
      if (Double.compare(changed, initial) != 0) {
        double sum = numbers[number.index()] + changed - initial;
        numbers[number.index()] =
            relaxed.settings().isSetting(number) || !Double.isFinite(sum)
                ? changed
                : Quantity.rounded(sum);
      }
    }
    return new State(codes, new NumberVector(numbers));
  }

  /** What the operator needs to be so. */
  private static Stream<Condition.Literal> literals(Operator operator) {
    return operator.precondition().conjuncts().stream()
        .filter(Condition.Literal.class::isInstance)
        .map(Condition.Literal.class::cast)
        .filter(literal -> literal.question() == Condition.Question.IS);
  }

  /** What the operator makes so in any case. */
  private static Stream<Change.Put> puts(Operator operator) {
    return operator.changes().stream()
        .filter(Change.Put.class::isInstance)
        .map(Change.Put.class::cast)
        .filter(put -> put.condition() == Condition.Constant.TRUE && !put.variable().functional());
  }
}
