package org.maestro.planning.optimal;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.State;
import org.maestro.planning.settings.SettingAnalysis;

/**
 * The landmark-cut lower bound of the cost from a state to the goal (Helmert and Domshlak 2009),
 * over {@link RelaxedProblem}. Actions of one operator share its cost. Costs of propositions are
 * brought up to date after each cut instead of computed anew. Not thread-safe.
 */
public final class LandmarkCut {
  private static final double NOTHING = 1e-9;

  private final RelaxedProblem relaxed;
  private final int[] payers;
  private final int[][] paidBy;
  private final int[][] preconditions;
  private final int[][] additions;
  private final int[][] consumers;
  private final int[][] achievers;
  private final int[] subject;
  private final int goal;

  private final double[] value;
  private final int[] supporter;
  private final int[] open;
  private final boolean[] inGoalZone;
  private final boolean[] inFrontZone;
  private final boolean[] paid;
  private final PropositionQueue queue;
  private final int[] stack;
  private final boolean[] inSomeCut;
  private double[] rest = {};

  public LandmarkCut(RelaxedProblem relaxed) {
    this.relaxed = relaxed;
    List<RelaxedProblem.Action> actions = relaxed.actions();
    int propositions = relaxed.propositionCount();
    payers = actions.stream().mapToInt(RelaxedProblem.Action::payer).toArray();
    preconditions =
        actions.stream().map(RelaxedProblem.Action::preconditions).toArray(int[][]::new);
    additions = actions.stream().map(RelaxedProblem.Action::additions).toArray(int[][]::new);
    consumers = relaxed.consumers();
    achievers = relaxed.inverse(additions);
    goal = relaxed.goal();
    value = new double[propositions];
    supporter = new int[actions.size()];
    open = new int[actions.size()];
    inGoalZone = new boolean[propositions];
    inFrontZone = new boolean[propositions];
    paid = new boolean[relaxed.payerCount()];
    paidBy =
        RelaxedProblem.inverse(
            IntStream.of(payers)
                .mapToObj(payer -> payer == RelaxedProblem.FREE ? new int[0] : new int[] {payer})
                .toArray(int[][]::new),
            relaxed.payerCount());
    inSomeCut = new boolean[relaxed.payerCount()];
    queue = new PropositionQueue();
    stack = new int[propositions];
    subject = new int[propositions];
    Arrays.setAll(subject, i -> subject(relaxed.leaf(i)));
  }

  private static int subject(Condition leaf) {
    return leaf instanceof Condition.Literal literal
        ? literal.variable().index()
        : Integer.MAX_VALUE;
  }

  /** The settings of the problem, and the sums of them. */
  SettingAnalysis settings() {
    return relaxed.settings();
  }

  /** Never more than the true cost; infinite when the goal is out of reach. */
  double estimate(State state) {
    boolean[] truths = relaxed.truths(state);
    double[] costs = relaxed.costs(state);
    Arrays.setAll(costs, payer -> nothingIfTiny(costs[payer]));
    Arrays.fill(inSomeCut, false);
    rest = costs;
    double total = 0;
    computeMaximumCosts(truths, costs);
    while (true) {
      if (value[goal] == Double.POSITIVE_INFINITY) {
        return Double.POSITIVE_INFINITY;
      }
      if (value[goal] == 0) {
        return total;
      }
      markGoalZone(costs);
      double cut = cutCost(truths, costs);
      for (int payer = 0; payer < paid.length; payer++) {
        if (paid[payer]) {
          inSomeCut[payer] = true;
          costs[payer] = nothingIfTiny(costs[payer] - cut);
          for (int action : paidBy[payer]) {
            offerAnew(action, costs);
          }
        }
      }
      lowerMaximumCosts(costs);
      total += cut;
    }
  }

  /**
   * Indices of the operators that were in a cut of the last estimate, ascending: of each cut, every
   * plan from there has one.
   */
  int[] landmarkOperators() {
    int operators = relaxed.problem().operators().size();
    boolean threshold =
        IntStream.range(operators, inSomeCut.length).anyMatch(payer -> inSomeCut[payer]);
    return IntStream.range(0, operators)
        .filter(o -> inSomeCut[o] || threshold && relaxed.isPaidForByThreshold(o))
        .toArray();
  }

  /**
   * What each operator costs besides the cuts of the last estimate: a plan costs at least the
   * estimate and the rests of all its steps.
   */
  double[] rests() {
    return Arrays.copyOf(rest, relaxed.problem().operators().size());
  }

  /**
   * For each operator the rests, of the last estimate, of what its precondition needs, at least;
   * infinite when that is out of reach. What the conditions of its changes need does not count: it
   * may be taken for what it ends, so that another operator does not change what it would.
   */
  double[] restsBefore() {
    double[] before = new double[relaxed.problem().operators().size()];
    for (int operator = 0; operator < before.length; operator++) {
      if (relaxed.isPaidForByThreshold(operator)) {
        continue;
      }
      if (relaxed.isPossible(operator)) {
        for (int needed : relaxed.needed(operator)) {
          before[operator] = Math.max(before[operator], value[needed]);
        }
      } else {
        before[operator] = Double.POSITIVE_INFINITY;
      }
    }
    return before;
  }

  /** Rounding errors must not look like costs. */
  private static double nothingIfTiny(double cost) {
    return cost < NOTHING ? 0 : cost;
  }

  private double cost(int action, double[] costs) {
    return payers[action] == RelaxedProblem.FREE ? 0 : costs[payers[action]];
  }

  /**
   * The h-max value of each proposition, and for each action the precondition that it has it from:
   * among equals the one of the first variable, as alternatives that agree on what they wait for
   * have small cuts.
   */
  private void computeMaximumCosts(boolean[] truths, double[] costs) {
    Arrays.fill(value, Double.POSITIVE_INFINITY);
    for (int action = 0; action < open.length; action++) {
      open[action] = preconditions[action].length;
      supporter[action] = -1;
    }
    queue.clear();
    for (int proposition = 0; proposition < truths.length; proposition++) {
      if (truths[proposition]) {
        value[proposition] = 0;
        queue.add(0, proposition);
      }
    }
    while (!queue.isEmpty()) {
      double now = queue.leastKey();
      int proposition = queue.removeLeast();
      if (now > value[proposition]) {
        continue;
      }
      for (int action : consumers[proposition]) {
        if (supporter[action] < 0 || supports(proposition, supporter[action])) {
          supporter[action] = proposition;
        }
        if (--open[action] == 0) {
          offer(action, costs);
        }
      }
    }
  }

  /** The same after costs have fallen, from what has been offered anew. */
  private void lowerMaximumCosts(double[] costs) {
    while (!queue.isEmpty()) {
      double now = queue.leastKey();
      int proposition = queue.removeLeast();
      if (now > value[proposition]) {
        continue;
      }
      for (int action : consumers[proposition]) {
        if (supporter[action] == proposition) {
          offerAnew(action, costs);
        }
      }
    }
  }

  private void offerAnew(int action, double[] costs) {
    if (open[action] == 0) {
      for (int needed : preconditions[action]) {
        if (supports(needed, supporter[action])) {
          supporter[action] = needed;
        }
      }
      offer(action, costs);
    }
  }

  private boolean supports(int proposition, int other) {
    return value[proposition] > value[other]
        || value[proposition] == value[other] && subject[proposition] < subject[other];
  }

  /** Lets what the action adds cost no more than by way of it. */
  private void offer(int action, double[] costs) {
    double reached = value[supporter[action]] + cost(action, costs);
    for (int added : additions[action]) {
      if (reached < value[added]) {
        value[added] = reached;
        queue.add(reached, added);
      }
    }
  }

  /** The propositions from which the goal is reached for nothing. */
  private void markGoalZone(double[] costs) {
    Arrays.fill(inGoalZone, false);
    int size = 0;
    inGoalZone[goal] = true;
    stack[size++] = goal;
    while (size > 0) {
      for (int action : achievers[stack[--size]]) {
        int from = supporter[action];
        if (open[action] == 0 && !inGoalZone[from] && cost(action, costs) == 0) {
          inGoalZone[from] = true;
          stack[size++] = from;
        }
      }
    }
  }

  /** Marks the payers of actions that enter the goal zone, and tells the cheapest's cost. */
  private double cutCost(boolean[] truths, double[] costs) {
    Arrays.fill(inFrontZone, false);
    Arrays.fill(paid, false);
    double least = Double.POSITIVE_INFINITY;
    int size = 0;
    for (int proposition = 0; proposition < truths.length; proposition++) {
      if (truths[proposition]) {
        inFrontZone[proposition] = true;
        stack[size++] = proposition;
      }
    }
    while (size > 0) {
      int proposition = stack[--size];
      for (int action : consumers[proposition]) {
        if (open[action] > 0
            || supporter[action] != proposition
            || cost(action, costs) == Double.POSITIVE_INFINITY) {
          continue;
        }
        for (int added : additions[action]) {
          if (inGoalZone[added]) {
            paid[payers[action]] = true;
            least = Math.min(least, costs[payers[action]]);
          } else if (!inFrontZone[added]) {
            inFrontZone[added] = true;
            stack[size++] = added;
          }
        }
      }
    }
    return least;
  }
}
