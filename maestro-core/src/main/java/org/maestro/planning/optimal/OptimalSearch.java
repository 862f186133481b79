package org.maestro.planning.optimal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import org.jspecify.annotations.Nullable;
import org.maestro.planning.api.Effort;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Successors;
import org.maestro.planning.settings.SettledSums;

/**
 * A* over the states of a ground problem. Estimates take longer than all else: a state has the
 * bound of the one before until it is its turn, and states behind operators of a landmark have
 * theirs before others. Ties: the smaller estimate, then fewer steps, then the state found first,
 * so that names play no part.
 */
public final class OptimalSearch {
  /** Sums of costs that differ by less are equal. */
  private static final double GRAIN = 1e9;

  /** Up to so many it takes longer to leave orders of operators out than to search them. */
  private static final int FEW_STATES = 500;

  /** Of so many the cuts are kept for the states after them: a hundred each, at times. */
  private static final int MOST_WITH_CUTS = 20_000;

  /** Of the state in which the search begins. */
  private static final int NONE = -1;

  /** No estimate was made yet. */
  private static final double UNEVALUATED = -1;

  /** The result of the search: a plan, exhaustion, or the bound that ended it. */
  public sealed interface Outcome {
    record Found(List<Operator> operators) implements Outcome {}

    /** All reachable states were seen, and none fulfils the goal. */
    record Exhausted(int states) implements Outcome {}

    record BoundReached(int states) implements Outcome {}

    /** A plan than which there may be cheaper ones. */
    record Unproven(List<Operator> operators) implements Outcome {}

    /** No plan is cheaper than this, and this is more than allowed. */
    record TooDear(double atLeast) implements Outcome {}
  }

  private static final class Node {
    private final State state;
    private double estimate = UNEVALUATED;
    private int[] landmarks = {};
    private List<LandmarkCut.Cut> cuts = List.of();
    private double cost;
    private int depth;
    private @Nullable Node parent;
    private int operator = NONE;

    private Node(State state) {
      this.state = state;
    }
  }

  private record Entry(
      long total, double estimate, int depth, long sequence, double cost, Node node)
      implements Comparable<Entry> {
    @Override
    public int compareTo(Entry other) {
      int byTotal = Long.compare(total, other.total);
      int byEstimate = byTotal != 0 ? byTotal : Double.compare(estimate, other.estimate);
      int byDepth = byEstimate != 0 ? byEstimate : Integer.compare(depth, other.depth);
      return byDepth != 0 ? byDepth : Long.compare(sequence, other.sequence);
    }
  }

  private final GroundProblem problem;
  private final LandmarkCut heuristic;
  private final Effort effort;
  private final double mostCost;
  private final double haste;
  private final SettledSums sums;
  private final BitSet all = new BitSet();
  private final Map<State, Node> nodes = new HashMap<>();
  private final PriorityQueue<Entry> queue = new PriorityQueue<>();
  private long sequence;
  private @Nullable StubbornSets stubborn;

  /**
   * @param effort that it may cost
   * @param mostCost that a plan may have; may be infinite
   */
  public OptimalSearch(
      GroundProblem problem, LandmarkCut heuristic, Effort effort, double mostCost) {
    this(problem, heuristic, effort, mostCost, 1);
  }

  private OptimalSearch(
      GroundProblem problem, LandmarkCut heuristic, Effort effort, double mostCost, double haste) {
    this.haste = haste;
    this.problem = problem;
    this.heuristic = heuristic;
    this.effort = effort;
    this.mostCost = mostCost;
    this.sums = new SettledSums(heuristic.settings(), problem.initial().numbers());
    this.all.set(0, problem.operators().size());
  }

  /** A search for some plan, which may cost up to that many times as much as the cheapest. */
  public static OptimalSearch hasty(
      GroundProblem problem, LandmarkCut heuristic, Effort effort, double times) {
    return new OptimalSearch(problem, heuristic, effort, Double.POSITIVE_INFINITY, times);
  }

  public Outcome run() {
    Condition goal = problem.goal().condition();
    Node initial = new Node(problem.initial());
    nodes.put(initial.state, initial);
    queue.add(new Entry(0, 0, 0, sequence++, 0, initial));
    while (!queue.isEmpty()) {
      Entry entry = queue.remove();
      Node node = entry.node();
      if (entry.cost() > node.cost) {
        continue;
      }
      if (entry.total() > total(mostCost)) {
        return new Outcome.TooDear(entry.total() / GRAIN);
      }
      if (node.estimate == UNEVALUATED) {
        evaluate(node, entry.total());
        continue;
      }
      if (goal.holds(node.state)) {
        return new Outcome.Found(operatorsTo(node));
      }
      if (nodes.size() > effort.mostStates() || effort.isSpent()) {
        return new Outcome.BoundReached(nodes.size());
      }
      expand(node, entry.total());
    }
    return new Outcome.Exhausted(nodes.size());
  }

  /** The bound of the node before holds too: a plan through this one goes through that one. */
  private void evaluate(Node node, long totalBefore) {
    node.estimate =
        node.parent == null
            ? heuristic.estimate(node.state)
            : heuristic.estimate(node.state, heuristic.after(node.operator, node.parent.cuts));
    effort.spend(heuristic.work());
    node.landmarks = heuristic.landmarkOperators();
    if (nodes.size() < MOST_WITH_CUTS) {
      node.cuts = heuristic.cuts();
    }
    if (node.estimate < Double.POSITIVE_INFINITY) {
      enqueue(node, total(totalBefore, node.cost, node.estimate), node.estimate);
    }
  }

  private long total(long totalBefore, double cost, double estimate) {
    return haste > 1
        ? total(cost + haste * estimate)
        : Math.max(totalBefore, total(cost + estimate));
  }

  private void expand(Node node, long totalBefore) {
    int[] landmarks = node.landmarks;
    node.landmarks = new int[0];
    BitSet enough = nodes.size() > FEW_STATES ? stubborn().of(node.state) : all;
    for (int i = enough.nextSetBit(0); i >= 0; i = enough.nextSetBit(i + 1)) {
      Operator operator = problem.operators().get(i);
      if (Successors.isApplicable(operator, node.state)) {
        State after = sums.settled(Successors.after(operator, node.state));
        if (!after.equals(node.state)) {
          double price = operator.price().cost(node.state.numbers());
          boolean promising = Arrays.binarySearch(landmarks, i) >= 0;
          double hoped = promising ? Math.max(0, node.estimate - price) : node.estimate;
          reach(after, node.cost + price, node, i, totalBefore, hoped);
        }
      }
    }
  }

  private StubbornSets stubborn() {
    if (stubborn == null) {
      stubborn = new StubbornSets(problem);
    }
    return stubborn;
  }

  private void reach(
      State state, double cost, Node parent, int operator, long totalBefore, double hoped) {
    Node node = nodes.get(state);
    if (node == null) {
      node = new Node(state);
      nodes.put(state, node);
    } else if (total(cost) >= total(node.cost) || node.estimate == Double.POSITIVE_INFINITY) {
      return;
    }
    node.cost = cost;
    node.parent = parent;
    node.operator = operator;
    node.depth = parent.depth + 1;
    if (node.estimate == UNEVALUATED) {
      enqueue(node, total(totalBefore, cost, haste > 1 ? hoped : 0), hoped);
    } else {
      enqueue(node, total(totalBefore, cost, node.estimate), node.estimate);
    }
  }

  private void enqueue(Node node, long total, double estimate) {
    queue.add(new Entry(total, estimate, node.depth, sequence++, node.cost, node));
  }

  private static long total(double cost) {
    return Math.round(cost * GRAIN);
  }

  private List<Operator> operatorsTo(Node last) {
    List<Operator> operators = new ArrayList<>();
    for (Node node = last; node != null && node.operator != NONE; node = node.parent) {
      operators.add(problem.operators().get(node.operator));
    }
    Collections.reverse(operators);
    return operators;
  }
}
