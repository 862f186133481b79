package org.maestro.planning;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;

/**
 * A* over the states of a ground problem. Ties: the smaller estimate, then fewer steps, then the
 * state found first, so that names play no part.
 */
final class OptimalSearch {
  /** Sums of costs that differ by less are equal. */
  private static final double GRAIN = 1e9;

  /** How the search ended. */
  sealed interface Outcome {
    record Found(List<Operator> operators) implements Outcome {}

    /** All reachable states were seen, and none fulfils the goal. */
    record Exhausted(int states) implements Outcome {}

    record BoundReached(int states) implements Outcome {}
  }

  private static final class Node {
    private final State state;
    private final double estimate;
    private double cost;
    private int depth;
    private Node parent;
    private Operator operator;

    private Node(State state, double estimate) {
      this.state = state;
      this.estimate = estimate;
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
  private final int mostStates;
  private final Map<State, Node> nodes = new HashMap<>();
  private final PriorityQueue<Entry> queue = new PriorityQueue<>();
  private long sequence;

  OptimalSearch(GroundProblem problem, LandmarkCut heuristic, int mostStates) {
    this.problem = problem;
    this.heuristic = heuristic;
    this.mostStates = mostStates;
  }

  Outcome run() {
    Condition goal = problem.goal().condition();
    reach(problem.initial(), 0, null, null);
    while (!queue.isEmpty()) {
      Entry entry = queue.remove();
      Node node = entry.node();
      if (entry.cost() > node.cost) {
        continue;
      }
      if (goal.holds(node.state)) {
        return new Outcome.Found(operatorsTo(node));
      }
      if (nodes.size() > mostStates) {
        return new Outcome.BoundReached(nodes.size());
      }
      for (Operator operator : problem.operators()) {
        if (Successors.isApplicable(operator, node.state)) {
          State after = Successors.after(operator, node.state);
          if (after != node.state) {
            double price = operator.price().cost(node.state.numbers());
            reach(after, node.cost + price, node, operator);
          }
        }
      }
    }
    return new Outcome.Exhausted(nodes.size());
  }

  private void reach(State state, double cost, Node parent, Operator operator) {
    Node node = nodes.get(state);
    if (node == null) {
      node = new Node(state, heuristic.estimate(state));
      nodes.put(state, node);
    } else if (Math.rint(cost * GRAIN) >= Math.rint(node.cost * GRAIN)) {
      return;
    }
    node.cost = cost;
    node.parent = parent;
    node.operator = operator;
    node.depth = parent == null ? 0 : parent.depth + 1;
    if (node.estimate < Double.POSITIVE_INFINITY) {
      long total = Math.round((cost + node.estimate) * GRAIN);
      queue.add(new Entry(total, node.estimate, node.depth, sequence++, cost, node));
    }
  }

  private static List<Operator> operatorsTo(Node last) {
    List<Operator> operators = new ArrayList<>();
    for (Node node = last; node.parent != null; node = node.parent) {
      operators.add(node.operator);
    }
    Collections.reverse(operators);
    return operators;
  }
}
