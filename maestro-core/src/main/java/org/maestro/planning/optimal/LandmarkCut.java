package org.maestro.planning.optimal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.State;
import org.maestro.planning.settings.SettingAnalysis;

/**
 * The landmark-cut lower bound of the cost from a state to the goal (Helmert and Domshlak 2009),
 * over {@link RelaxedProblem}. Actions of one operator share its cost. Costs of propositions are
 * brought up to date after each cut instead of computed anew, and the cuts of a state serve those
 * after it. Where there are many actions, the cuts are made of coarse grains of the costs first,
 * then of finer ones, and the finest are left out. Not thread-safe.
 */
public final class LandmarkCut {
  private static final double NOTHING = 1e-9;

  /**
   * Prices that differ a little make many cuts that bring little; among so many actions each takes
   * long.
   */
  private static final int MANY_ACTIONS = 10_000;

  /** In what the goal costs at least at first. */
  private static final int FIRST_GRAINS = 32;

  private static final int FINER = 4;

  private static final int ROUNDS = 3;

  /**
   * A disjunctive action landmark: every plan pays one of these.
   *
   * @param payers ascending
   * @param cost that is counted for it
   */
  record Cut(int[] payers, double cost) {}

  private final RelaxedProblem relaxed;
  private final int mostExact;
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

  /** Of each proposition the action by which it is had for its value; none of what is true. */
  private final int[] reachedBy;

  /** Actions that cost something and lead into the goal zone, perhaps from within it. */
  private int[] edges = new int[64];

  private int edgeCount;
  private final boolean[] paid;
  private int[] cutPayers = new int[64];
  private final PropositionQueue queue;
  private final int[] stack;
  private final boolean[] inSomeCut;
  private List<Cut> cuts = List.of();
  private double[] rest = {};
  private long work;

  public LandmarkCut(RelaxedProblem relaxed) {
    this(relaxed, MANY_ACTIONS);
  }

  /**
   * @param mostExact with more actions than these the cuts are made of whole grains
   */
  LandmarkCut(RelaxedProblem relaxed, int mostExact) {
    this.relaxed = relaxed;
    this.mostExact = mostExact;
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
    reachedBy = new int[propositions];
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
    return estimate(state, List.of());
  }

  /**
   * As {@link #estimate(State)}, from cuts that are known to be ones of the state (Pommerening and
   * Helmert 2013): only the others have to be found.
   */
  double estimate(State state, List<Cut> known) {
    boolean[] truths = relaxed.truths(state);
    double[] costs = relaxed.costs(state);
    Arrays.setAll(costs, payer -> nothingIfTiny(costs[payer]));
    Arrays.fill(inSomeCut, false);
    rest = costs;
    cuts = new ArrayList<>(known);
    work = 0;
    double total = 0;
    for (Cut cut : known) {
      pay(cut, costs);
      total += cut.cost();
    }
    computeMaximumCosts(truths, costs);
    if (open.length <= mostExact) {
      return total + total(truths, costs);
    }
    double grain = value[goal] / FIRST_GRAINS;
    for (int round = 0;
        round < ROUNDS && value[goal] > 0 && value[goal] < Double.POSITIVE_INFINITY;
        round++) {
      double[] fine = withoutFine(costs, grain);
      computeMaximumCosts(truths, costs);
      total += total(truths, costs);
      Arrays.setAll(costs, payer -> costs[payer] + fine[payer]);
      computeMaximumCosts(truths, costs);
      grain /= FINER;
    }
    return value[goal] == Double.POSITIVE_INFINITY ? value[goal] : total;
  }

  /** Leaves of the costs whole grains, and returns the rest. */
  private static double[] withoutFine(double[] costs, double grain) {
    double[] fine = new double[costs.length];
    for (int payer = 0; payer < costs.length; payer++) {
      if (costs[payer] < Double.POSITIVE_INFINITY) {
        double whole = Math.floor(costs[payer] / grain) * grain;
        fine[payer] = costs[payer] - whole;
        costs[payer] = whole;
      }
    }
    return fine;
  }

  /** What the cuts cost that are left to be made. */
  private double total(boolean[] truths, double[] costs) {
    double total = 0;
    while (true) {
      if (value[goal] == Double.POSITIVE_INFINITY) {
        return Double.POSITIVE_INFINITY;
      }
      if (value[goal] == 0) {
        return total;
      }
      markGoalZone(costs);
      Cut cut = cut(truths, costs);
      pay(cut, costs);
      for (int payer : cut.payers()) {
        for (int action : paidBy[payer]) {
          offerAnew(action, costs);
        }
      }
      lowerMaximumCosts(costs);
      cuts.add(cut);
      total += cut.cost();
    }
  }

  private void pay(Cut cut, double[] costs) {
    for (int payer : cut.payers()) {
      inSomeCut[payer] = true;
      costs[payer] = nothingIfTiny(costs[payer] - cut.cost());
    }
  }

  /** The cuts of the last estimate, the known ones first. */
  List<Cut> cuts() {
    return cuts;
  }

  /**
   * Those of the cuts that are ones of the state after the operator too: whoever plans on from
   * there has not paid them yet. What thresholds cost depends on the state.
   */
  List<Cut> after(int operator, List<Cut> before) {
    int operators = relaxed.problem().operators().size();
    return before.stream()
        .filter(cut -> cut.payers()[cut.payers().length - 1] < operators)
        .filter(cut -> Arrays.binarySearch(cut.payers(), operator) < 0)
        .toList();
  }

  /** How often the last estimate looked at an action. */
  long work() {
    return work;
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
      work += consumers[proposition].length;
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
      work += consumers[proposition].length;
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
        reachedBy[added] = action;
        queue.add(reached, added);
      }
    }
  }

  /** The propositions from which the goal is reached for nothing, and what leads there. */
  private void markGoalZone(double[] costs) {
    Arrays.fill(inGoalZone, false);
    edgeCount = 0;
    int size = 0;
    inGoalZone[goal] = true;
    stack[size++] = goal;
    while (size > 0) {
      int proposition = stack[--size];
      work += achievers[proposition].length;
      for (int action : achievers[proposition]) {
        int from = supporter[action];
        if (open[action] > 0 || inGoalZone[from]) {
          continue;
        }
        if (cost(action, costs) == 0) {
          inGoalZone[from] = true;
          stack[size++] = from;
        } else if (cost(action, costs) < Double.POSITIVE_INFINITY) {
          edges = withRoom(edges, edgeCount);
          edges[edgeCount++] = action;
        }
      }
    }
  }

  private static int[] withRoom(int[] array, int size) {
    return size < array.length ? array : Arrays.copyOf(array, 2 * size);
  }

  /** Those who pay for actions that enter the goal zone, and what the cheapest of them costs. */
  private Cut cut(boolean[] truths, double[] costs) {
    System.arraycopy(truths, 0, inFrontZone, 0, truths.length);
    double least = Double.POSITIVE_INFINITY;
    boolean isFrontWhole = false;
    int cutSize = 0;
    for (int i = 0; i < edgeCount; i++) {
      int from = supporter[edges[i]];
      int payer = payers[edges[i]];
      if (inGoalZone[from] || paid[payer]) {
        continue;
      }
      if (!inFrontZone[from] && !isFrontWhole && !leadsBackToFront(from)) {
        markFrontZone(truths, costs);
        isFrontWhole = true;
      }
      if (inFrontZone[from]) {
        paid[payer] = true;
        cutPayers = withRoom(cutPayers, cutSize);
        cutPayers[cutSize++] = payer;
        least = Math.min(least, costs[payer]);
      }
    }
    for (int i = 0; i < cutSize; i++) {
      paid[cutPayers[i]] = false;
    }
    int[] cut = Arrays.copyOf(cutPayers, cutSize);
    Arrays.sort(cut);
    return new Cut(cut, least);
  }

  /**
   * Whether the way on which the proposition is had soonest begins in the front zone and keeps out
   * of the goal zone; then all of it is in the front zone. If not, another way may.
   */
  private boolean leadsBackToFront(int last) {
    int size = 0;
    int proposition = last;
    while (!inFrontZone[proposition]) {
      int by = reachedBy[proposition];
      // What costs nothing may have been found to lead to each other in a circle.
      if (size == stack.length || inGoalZone[proposition] || entersGoalZone(by)) {
        return false;
      }
      stack[size++] = proposition;
      proposition = supporter[by];
    }
    while (size > 0) {
      inFrontZone[stack[--size]] = true;
    }
    return true;
  }

  private boolean entersGoalZone(int action) {
    for (int added : additions[action]) {
      if (inGoalZone[added]) {
        return true;
      }
    }
    return false;
  }

  /** All that can be had without the goal zone. */
  private void markFrontZone(boolean[] truths, double[] costs) {
    int size = 0;
    for (int proposition = 0; proposition < truths.length; proposition++) {
      inFrontZone[proposition] = truths[proposition];
      if (truths[proposition]) {
        stack[size++] = proposition;
      }
    }
    while (size > 0) {
      int proposition = stack[--size];
      work += consumers[proposition].length;
      for (int action : consumers[proposition]) {
        if (open[action] > 0
            || supporter[action] != proposition
            || cost(action, costs) == Double.POSITIVE_INFINITY) {
          continue;
        }
        for (int added : additions[action]) {
          if (!inGoalZone[added] && !inFrontZone[added]) {
            inFrontZone[added] = true;
            stack[size++] = added;
          }
        }
      }
    }
  }
}
