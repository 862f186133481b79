package org.maestro.planning.optimal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.Condition.Constant;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Variable;
import org.maestro.planning.problem.VariableValue;
import org.maestro.planning.settings.Achievement;
import org.maestro.planning.settings.SettingAnalysis;
import org.maestro.planning.settings.Threshold;

/**
 * The delete relaxation of a ground problem, built backwards from its goal: propositions, once
 * true, stay true. Each change of an operator is an action of its own, but all actions of an
 * operator are paid for once. Disjunctions become propositions with free actions. Thresholds of
 * sums are reached by actions whose price {@link SettingAnalysis} computes for each state.
 */
public final class RelaxedProblem {
  /** The payer of an action that costs nothing. */
  public static final int FREE = -1;

  /** A conjunction of propositions brings about others. */
  public record Action(int payer, int[] preconditions, int[] additions) {}

  /** The proposition that is always true. */
  static final int TRUTH = 0;

  private static final int NEVER = -1;
  private static final int[] IMPOSSIBLE = {NEVER};

  private final GroundProblem problem;
  private final SettingAnalysis settings;
  private final List<Condition> leaves = new ArrayList<>();
  private final Map<Condition, Integer> indexOfLeaf = new LinkedHashMap<>();
  private final Map<Object, List<OperatorChange>> changesOf = new LinkedHashMap<>();

  /** Where a thing is has as many values as a house has places, and far more changes. */
  private final Map<VariableValue, List<OperatorChange>> changesTo = new HashMap<>();

  /** Of each variable the values that it is given. */
  private final Map<Variable, Set<Integer>> valuesPut = new HashMap<>();

  /** For what a variable is given the proposition that it was. */
  private final Map<VariableValue, Integer> arrivals = new HashMap<>();

  private final List<Action> actions = new ArrayList<>();
  private final int[][] needed;
  private final ThresholdPrices prices;
  private final double[] operatorCosts;
  private final boolean[] paidForByThreshold;
  private int payers;
  private int @Nullable [][] consumers;
  private final int goal;

  private record OperatorChange(int operator, Change change) {}

  public RelaxedProblem(GroundProblem problem) {
    this.problem = problem;
    this.settings = new SettingAnalysis(problem);
    leaves.add(Constant.TRUE);
    List<Operator> operators = problem.operators();
    needed = new int[operators.size()][];
    for (int i = 0; i < operators.size(); i++) {
      for (Change change : operators.get(i).changes()) {
        OperatorChange candidate = new OperatorChange(i, change);
        changesOf.computeIfAbsent(change.target(), absent -> new ArrayList<>()).add(candidate);
        if (change instanceof Change.OfVariable of) {
          changesTo
              .computeIfAbsent(
                  new VariableValue(of.variable(), of.value()), absent -> new ArrayList<>())
              .add(candidate);
        }
        if (change instanceof Change.Put put) {
          valuesPut
              .computeIfAbsent(put.variable(), absent -> new LinkedHashSet<>())
              .add(put.value());
        }
      }
    }
    goal = auxiliary();
    addAlternative(goal, problem.goal().condition());
    Map<Threshold, List<Integer>> thresholds = new LinkedHashMap<>();
    for (int proposition = 1; proposition < leaves.size(); proposition++) {
      Condition leaf = leaves.get(proposition);
      if (leaf != Constant.FALSE) {
        Optional<Threshold> threshold = thresholdOfSum(leaf);
        if (threshold.isPresent()) {
          thresholds.computeIfAbsent(threshold.get(), absent -> new ArrayList<>()).add(proposition);
        }
        addAchievers(proposition, leaf, threshold.isPresent());
      }
    }
    prices = new ThresholdPrices(settings.sums(), thresholds.keySet());
    addThresholds(thresholds);
    operatorCosts = new double[operators.size()];
    paidForByThreshold = new boolean[operators.size()];
    for (int i = 0; i < operatorCosts.length; i++) {
      Operator operator = operators.get(i);
      paidForByThreshold[i] = settings.settingOf(operator).filter(prices::paysFor).isPresent();
      operatorCosts[i] =
          paidForByThreshold[i] ? 0 : settings.leastCost(operator, problem.initial().numbers());
    }
  }

  /** Stands for a disjunction, or the goal; no state makes it true by itself. */
  private int auxiliary() {
    leaves.add(Constant.FALSE);
    return leaves.size() - 1;
  }

  private void addAlternative(int proposition, Condition condition) {
    int[] needed = propositions(condition);
    if (needed != null) {
      actions.add(new Action(FREE, needed, new int[] {proposition}));
    }
  }

  /** The propositions that together mean the condition; null when it is false. */
  private int @Nullable [] propositions(Condition condition) {
    List<Condition> conjuncts = condition.conjuncts();
    int[] result = new int[conjuncts.size()];
    for (int i = 0; i < result.length; i++) {
      result[i] = proposition(conjuncts.get(i));
      if (result[i] == NEVER) {
        return null;
      }
    }
    return result.length == 0 ? new int[] {TRUTH} : result;
  }

  private int proposition(Condition condition) {
    if (condition instanceof Constant) {
      return condition == Constant.TRUE ? TRUTH : NEVER;
    }
    Integer known = indexOfLeaf.get(condition);
    if (known != null) {
      return known;
    }
    if (condition instanceof Condition.Any any) {
      int proposition = auxiliary();
      indexOfLeaf.put(condition, proposition);
      any.parts().forEach(part -> addAlternative(proposition, part));
      return proposition;
    }
    leaves.add(condition);
    indexOfLeaf.put(condition, leaves.size() - 1);
    return leaves.size() - 1;
  }

  private Optional<Threshold> thresholdOfSum(Condition leaf) {
    return leaf instanceof Condition.Compare compare
        ? Threshold.of(compare).filter(found -> settings.sum(found.variable()).isPresent())
        : Optional.empty();
  }

  private void addAchievers(int proposition, Condition leaf, boolean ofSum) {
    if (leaf instanceof Condition.Literal literal && literal.question() == Condition.Question.IS) {
      changesTo
          .getOrDefault(new VariableValue(literal.variable(), literal.value()), List.of())
          .forEach(candidate -> addAchiever(proposition, leaf, candidate));
      return;
    }
    if (leaf instanceof Condition.Literal literal
        && literal.question() == Condition.Question.IS_NOT) {
      addDepartures(proposition, literal);
      return;
    }
    for (Object target : targets(leaf)) {
      for (OperatorChange candidate : changesOf.getOrDefault(target, List.of())) {
        if (!(ofSum && candidate.change() instanceof Change.Adjust)) {
          addAchiever(proposition, leaf, candidate);
        }
      }
    }
  }

  /**
   * A thing is not in one hand any more wherever else it is brought: that it came there stands
   * between, so that not each change of its place stands beside each hand.
   */
  private void addDepartures(int proposition, Condition.Literal literal) {
    VariableValue left = new VariableValue(literal.variable(), literal.value());
    changesTo.getOrDefault(left, List.of()).stream()
        .filter(candidate -> candidate.change() instanceof Change.Remove)
        .forEach(candidate -> addAchiever(proposition, literal, candidate));
    for (int value : valuesPut.getOrDefault(literal.variable(), Set.of())) {
      if (value != literal.value()) {
        int[] arrived = {arrival(new VariableValue(literal.variable(), value))};
        actions.add(new Action(FREE, arrived, new int[] {proposition}));
      }
    }
  }

  private int arrival(VariableValue place) {
    Integer known = arrivals.get(place);
    if (known != null) {
      return known;
    }
    int arrival = auxiliary();
    arrivals.put(place, arrival);
    Condition arrived =
        new Condition.Literal(place.variable(), place.value(), Condition.Question.IS);
    changesTo.getOrDefault(place, List.of()).stream()
        .filter(candidate -> candidate.change() instanceof Change.Put)
        .forEach(candidate -> addAchiever(arrival, arrived, candidate));
    return arrival;
  }

  private void addAchiever(int proposition, Condition leaf, OperatorChange candidate) {
    Condition requirement = Achievement.requirement(candidate.change(), leaf, settings);
    if (requirement == Constant.FALSE) {
      return;
    }
    int operator = candidate.operator();
    if (needed[operator] == null) {
      int[] conditions = propositions(problem.operators().get(operator).precondition());
      needed[operator] = conditions == null ? IMPOSSIBLE : conditions;
    }
    int[] ofChange = propositions(candidate.change().condition());
    int[] required = propositions(requirement);
    if (needed[operator] != IMPOSSIBLE && ofChange != null && required != null) {
      int[] all = joined(joined(needed[operator], ofChange), required);
      actions.add(new Action(operator, all, new int[] {proposition}));
    }
  }

  /** All of the first and those of the second that are new. */
  private static int[] joined(int[] first, int[] second) {
    int[] joined = Arrays.copyOf(first, first.length + second.length);
    int size = first.length;
    for (int proposition : second) {
      boolean isNew = proposition != TRUTH;
      for (int i = 0; isNew && i < first.length; i++) {
        isNew = first[i] != proposition;
      }
      if (isNew) {
        joined[size++] = proposition;
      }
    }
    return size == joined.length ? joined : Arrays.copyOf(joined, size);
  }

  private static Collection<Object> targets(Condition leaf) {
    if (leaf instanceof Condition.Literal literal) {
      return List.of(literal.variable());
    } else if (leaf instanceof Condition.NumberKnown known) {
      return List.of(known.variable());
    }
    Set<Object> targets = new LinkedHashSet<>();
    if (leaf instanceof Condition.Compare compare) {
      compare.left().forEachVariable(targets::add);
      compare.right().forEachVariable(targets::add);
    }
    return targets;
  }

  /**
   * In each cluster the thresholds are reached in the order of their costs, by as many ranks: a
   * rank costs the difference to the one before, and a gate, open or closed depending on the state,
   * leads from it to the threshold that stands there.
   */
  private void addThresholds(Map<Threshold, List<Integer>> propositionsOf) {
    int payer = problem.operators().size();
    for (List<Threshold> cluster : prices.clusters()) {
      int before = TRUTH;
      for (int rank = 0; rank < cluster.size(); rank++) {
        int here = auxiliary();
        actions.add(new Action(payer++, new int[] {before}, new int[] {here}));
        for (Threshold threshold : cluster) {
          int[] reached =
              Objects.requireNonNull(propositionsOf.get(threshold)).stream()
                  .mapToInt(Integer::intValue)
                  .toArray();
          actions.add(new Action(payer++, new int[] {here}, reached));
        }
        before = here;
      }
    }
    payers = payer;
  }

  private void fillThresholdCosts(NumberVector numbers, double[] costs) {
    int payer = operatorCosts.length;
    for (double[] cluster : prices.costs(numbers)) {
      boolean[] placed = new boolean[cluster.length];
      double before = 0;
      for (int rank = 0; rank < cluster.length; rank++) {
        int next = cheapest(cluster, placed);
        placed[next] = true;
        boolean reachable = cluster[next] < Double.POSITIVE_INFINITY;
        costs[payer++] = reachable ? cluster[next] - before : Double.POSITIVE_INFINITY;
        before = cluster[next];
        for (int threshold = 0; threshold < cluster.length; threshold++) {
          costs[payer++] = threshold == next && reachable ? 0 : Double.POSITIVE_INFINITY;
        }
      }
    }
  }

  private static int cheapest(double[] cluster, boolean[] placed) {
    int best = -1;
    for (int i = 0; i < cluster.length; i++) {
      if (!placed[i] && (best < 0 || cluster[i] < cluster[best])) {
        best = i;
      }
    }
    return best;
  }

  GroundProblem problem() {
    return problem;
  }

  public SettingAnalysis settings() {
    return settings;
  }

  public List<Action> actions() {
    return actions;
  }

  public int propositionCount() {
    return leaves.size();
  }

  /** The condition a proposition stands for; false for a disjunction. */
  public Condition leaf(int proposition) {
    return leaves.get(proposition);
  }

  public int goal() {
    return goal;
  }

  int payerCount() {
    return payers;
  }

  /** Whether the operator is paid for where it helps to reach a threshold of a sum. */
  boolean isPaidForByThreshold(int operator) {
    return paidForByThreshold[operator];
  }

  public boolean[] truths(State state) {
    boolean[] truths = new boolean[leaves.size()];
    for (int i = 0; i < truths.length; i++) {
      truths[i] = leaves.get(i).holds(state);
    }
    return truths;
  }

  /**
   * What payers cost in the state: operators first, then thresholds of sums; infinite when out of
   * reach.
   */
  public double[] costs(State state) {
    double[] costs = Arrays.copyOf(operatorCosts, payers);
    fillThresholdCosts(state.numbers(), costs);
    return costs;
  }

  /** Which propositions can be made true from the state, each action being free. */
  public boolean[] reachable(State state) {
    return reachable(truths(state), costs(state));
  }

  public boolean[] reachable(boolean[] truths, double[] costs) {
    boolean[] reached = truths.clone();
    int[] open = new int[actions.size()];
    int[] stack = new int[reached.length];
    int size = 0;
    for (int action = 0; action < open.length; action++) {
      open[action] = actions.get(action).preconditions().length;
    }
    for (int proposition = 0; proposition < reached.length; proposition++) {
      if (reached[proposition]) {
        stack[size++] = proposition;
      }
    }
    while (size > 0) {
      for (int index : consumers()[stack[--size]]) {
        Action action = actions.get(index);
        if (--open[index] == 0
            && (action.payer() == FREE || Double.isFinite(costs[action.payer()]))) {
          for (int added : action.additions()) {
            if (!reached[added]) {
              reached[added] = true;
              stack[size++] = added;
            }
          }
        }
      }
    }
    return reached;
  }

  /** For each proposition the actions that need it. */
  public int[][] consumers() {
    if (consumers == null) {
      consumers = inverse(actions.stream().map(Action::preconditions).toArray(int[][]::new));
    }
    return consumers;
  }

  /** Whether nothing that its precondition needs is always false. */
  boolean isPossible(int operator) {
    return needed[operator] != IMPOSSIBLE;
  }

  /** What the precondition of an operator needs, where that was asked; or nothing. */
  int[] needed(int operator) {
    return needed[operator] == null ? new int[0] : needed[operator];
  }

  /** For each proposition the lists in which it stands. */
  int[][] inverse(int[][] lists) {
    return inverse(lists, leaves.size());
  }

  /**
   * For each entry the lists in which it stands.
   *
   * @param entries how many there are
   */
  static int[][] inverse(int[][] lists, int entries) {
    int[] counts = new int[entries];
    for (int[] list : lists) {
      for (int entry : list) {
        counts[entry]++;
      }
    }
    int[][] inverse = new int[counts.length][];
    Arrays.setAll(inverse, i -> new int[counts[i]]);
    for (int i = lists.length - 1; i >= 0; i--) {
      for (int entry : lists[i]) {
        inverse[entry][--counts[entry]] = i;
      }
    }
    return inverse;
  }

  /** The conditions that no sequence of operators can bring about from the initial state. */
  Set<Condition> unreachableLeaves() {
    boolean[] reached = reachable(problem.initial());
    Set<Condition> unreachable = new LinkedHashSet<>();
    for (int i = 1; i < reached.length; i++) {
      if (!reached[i] && leaves.get(i) != Constant.FALSE) {
        unreachable.add(leaves.get(i));
      }
    }
    return unreachable;
  }

  /** The conditions that may be brought about, as far as the relaxation tells. */
  public Set<Condition> reachableLeaves() {
    boolean[] reached = reachable(problem.initial());
    Set<Condition> reachable = new LinkedHashSet<>();
    for (int i = 1; i < reached.length; i++) {
      if (reached[i]) {
        reachable.add(leaves.get(i));
      }
    }
    return reachable;
  }

  public boolean isSolvable() {
    return reachable(problem.initial())[goal];
  }
}
