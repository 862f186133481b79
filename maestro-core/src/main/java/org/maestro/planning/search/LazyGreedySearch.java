package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.maestro.planning.ground.GroundingBudget;

/**
 * Lazy best-first search with preferred operators: a state is estimated when it is its turn, and
 * has its parent's estimate until then. With a weight of its own cost it finds cheaper plans later;
 * states that cannot lead to a plan below the bound are left out.
 */
final class LazyGreedySearch {
  private static final int BOOST = 1000;

  private final SearchTask task;
  private final RelaxedPlan heuristic;
  private final GroundingBudget patience;
  private final long memory;
  private final int mostStates;
  private final StateTable table;
  private long[] cost = new long[1024];
  private int[] parent = new int[1024];
  private int[] operatorTo = new int[1024];
  private final IntHeap ordinary = new IntHeap();
  private final IntHeap preferred = new IntHeap();
  private int ordinaryTurn;
  private int preferredTurn;
  private boolean outOfMemory;
  private long best = Long.MAX_VALUE;

  /** Edges that wait: from a state by an operator. */
  private int[] edgeFrom = new int[4096];

  private int[] edgeOperator = new int[4096];
  private int edges;

  /**
   * @param memory how many bytes may be used, about
   * @param mostStates with so many the search ends too, as if memory was used up
   */
  LazyGreedySearch(
      SearchTask task,
      RelaxedPlan heuristic,
      GroundingBudget patience,
      long memory,
      int mostStates) {
    this.mostStates = mostStates;
    this.task = task;
    this.heuristic = heuristic;
    this.patience = patience;
    this.memory = memory;
    this.table = new StateTable(task.initial.length);
  }

  /** Whether the search ended because states took too much memory. */
  boolean isOutOfMemory() {
    return outOfMemory;
  }

  /**
   * A plan.
   *
   * @param weight of the estimate against the cost so far; 0 for the estimate alone
   * @param below only plans that cost less are looked for
   * @return empty when there is none below the bound, or memory is used up
   * @throws java.util.concurrent.CancellationException when patience is over
   */
  Optional<List<Integer>> run(int weight, long below) {
    int first = table.number(task.initial);
    cost[first] = 0;
    parent[first] = -1;
    if (task.isGoal(task.initial)) {
      return below > 0 ? Optional.of(List.of()) : Optional.empty();
    }
    expand(first, weight, below);
    while (!ordinary.isEmpty() || !preferred.isEmpty()) {
      if (table.size() >= mostStates || table.bytes() + 20L * table.size() + 32L * edges > memory) {
        outOfMemory = true;
        return Optional.empty();
      }
      int edge = next();
      int from = edgeFrom[edge];
      int operator = edgeOperator[edge];
      long reached = cost[from] + task.cost[operator];
      if (reached >= below) {
        continue;
      }
      int before = table.size();
      int number = table.number(task.after(table.state(from), operator));
      boolean isNew = number == before;
      if (isNew) {
        grow(number);
      } else if (weight == 0 || reached >= cost[number]) {
        continue;
      }
      cost[number] = reached;
      parent[number] = from;
      operatorTo[number] = operator;
      if (task.isGoal(table.state(number))) {
        return Optional.of(plan(number));
      }
      expand(number, weight, below);
    }
    return Optional.empty();
  }

  private int next() {
    boolean takePreferred =
        !preferred.isEmpty() && (ordinary.isEmpty() || preferredTurn <= ordinaryTurn);
    if (takePreferred) {
      preferredTurn++;
      return preferred.removeLeast();
    }
    ordinaryTurn++;
    return ordinary.removeLeast();
  }

  private void expand(int number, int weight, long below) {
    patience.check();
    long estimate = heuristic.estimate(table.state(number));
    if (estimate >= RelaxedPlan.INFINITE) {
      return;
    }
    if (estimate < best) {
      best = estimate;
      preferredTurn -= BOOST;
    }
    for (int i = 0; i < heuristic.applicableCount(); i++) {
      int operator = heuristic.applicable(i);
      if (cost[number] + task.cost[operator] >= below) {
        continue;
      }
      long key = weight == 0 ? estimate : cost[number] + weight * estimate;
      int edge = edge(number, operator);
      ordinary.add(key, edge);
      if (heuristic.isPreferred(operator)) {
        preferred.add(key, edge);
      }
    }
  }

  private int edge(int from, int operator) {
    if (edges == edgeFrom.length) {
      edgeFrom = Arrays.copyOf(edgeFrom, 2 * edges);
      edgeOperator = Arrays.copyOf(edgeOperator, 2 * edges);
    }
    edgeFrom[edges] = from;
    edgeOperator[edges] = operator;
    return edges++;
  }

  private void grow(int number) {
    if (number >= cost.length) {
      int size = 2 * number;
      cost = Arrays.copyOf(cost, size);
      parent = Arrays.copyOf(parent, size);
      operatorTo = Arrays.copyOf(operatorTo, size);
    }
  }

  private List<Integer> plan(int last) {
    List<Integer> operators = new ArrayList<>();
    for (int number = last; parent[number] >= 0; number = parent[number]) {
      operators.add(operatorTo[number]);
    }
    Collections.reverse(operators);
    return operators;
  }
}
