package org.maestro.planning.sensing;

import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.optimal.PropositionQueue;
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
  private static final int INITIAL = -1;
  private static final int NONE = -2;

  private final GroundProblem problem;
  private final Sought sought;
  private final RelaxedProblem relaxed;
  private final Map<StepKey, Operator> operatorByKey = new HashMap<>();
  private final double[] value;
  private final int[] supporter;
  private final double[] sums;
  private final int[] open;
  private final int[] allOpen;
  private final PropositionQueue queue = new PropositionQueue();

  /** For each operator the indices of the values at which it looks. */
  private final int[][] looksOf;

  /** For each value the first operator that looks at it. */
  private final int[] firstLook;

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
    this.value = new double[relaxed.propositionCount()];
    this.supporter = new int[value.length];
    this.sums = new double[relaxed.actions().size()];
    this.open = new int[sums.length];
    this.allOpen =
        relaxed.actions().stream().mapToInt(action -> action.preconditions().length).toArray();
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
    computeSums(relaxed.truths(state), costs, NONE);
    double[] least = new double[sought.values().size()];
    Arrays.fill(least, Double.POSITIVE_INFINITY);
    for (RelaxedProblem.Action action : relaxed.actions()) {
      if (action.payer() >= 0 && action.payer() < problem.operators().size()) {
        Operator operator = problem.operators().get(action.payer());
        for (int i : looksOf[action.payer()]) {
          double sum = sum(action.preconditions(), costs);
          double cost = sum + operator.price().cost(state.numbers());
          least[i] = Double.isNaN(cost) ? least[i] : Math.min(least[i], cost);
        }
      }
    }
    return least;
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
   * The cost from a successful look on to the goal.
   *
   * @param before the state before all that the look needs
   * @param look the state after a successful look that began at first, which shows what it changes
   */
  double rest(State before, State look, int found) {
    State state = joined(before, look, found);
    double[] costs = relaxed.costs(state);
    computeSums(relaxed.truths(state), costs, relaxed.goal());
    return sum(new int[] {relaxed.goal()}, costs);
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
    for (Condition condition : operator.precondition().conjuncts()) {
      if (condition instanceof Condition.Literal literal
          && literal.question() == Condition.Question.IS) {
        codes[literal.variable().index()] = literal.value();
      }
    }
    for (Change change : operator.changes()) {
      if (change instanceof Change.Put put
          && put.condition() == Condition.Constant.TRUE
          && !put.variable().functional()) {
        codes[put.variable().index()] = put.value();
      }
    }
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

  private double sum(int[] propositions, double[] costs) {
    Set<Integer> payers = new LinkedHashSet<>();
    Set<Integer> seen = new LinkedHashSet<>();
    for (int needed : propositions) {
      if (!collect(needed, payers, seen)) {
        return Double.POSITIVE_INFINITY;
      }
    }
    double sum = 0;
    for (int payer : payers) {
      sum += costs[payer];
    }
    return sum;
  }

  /** Whoever has to be paid for the proposition; each once. False when it is out of reach. */
  private boolean collect(int proposition, Set<Integer> payers, Set<Integer> seen) {
    if (supporter[proposition] == INITIAL || !seen.add(proposition)) {
      return true;
    }
    if (supporter[proposition] == NONE) {
      return false;
    }
    RelaxedProblem.Action action = relaxed.actions().get(supporter[proposition]);
    if (action.payer() != RelaxedProblem.FREE) {
      payers.add(action.payer());
    }
    for (int needed : action.preconditions()) {
      if (!collect(needed, payers, seen)) {
        return false;
      }
    }
    return true;
  }

  /**
   * For each proposition the cheapest way by the sum of what its conditions cost.
   *
   * @param last the only one that is asked for, with what it rests on; none: all are
   */
  private void computeSums(boolean[] truths, double[] costs, int last) {
    Arrays.fill(value, Double.POSITIVE_INFINITY);
    Arrays.fill(supporter, NONE);
    Arrays.fill(sums, 0);
    System.arraycopy(allOpen, 0, open, 0, open.length);
    queue.clear();
    for (int i = 0; i < value.length; i++) {
      if (truths[i]) {
        reach(i, 0, INITIAL);
      }
    }
    while (!queue.isEmpty()) {
      double now = queue.leastKey();
      int proposition = queue.removeLeast();
      if (now > value[proposition]) {
        continue;
      }
      if (proposition == last) {
        return;
      }
      for (int index : relaxed.consumers()[proposition]) {
        sums[index] += now;
        if (--open[index] == 0) {
          RelaxedProblem.Action action = relaxed.actions().get(index);
          double own = action.payer() == RelaxedProblem.FREE ? 0 : costs[action.payer()];
          for (int added : action.additions()) {
            reach(added, sums[index] + own, index);
          }
        }
      }
    }
  }

  private void reach(int proposition, double sum, int by) {
    if (sum < value[proposition]) {
      value[proposition] = sum;
      supporter[proposition] = by;
      queue.add(sum, proposition);
    }
  }
}
