package org.maestro.planning.search;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.GroundingBudget;

/**
 * Leaves out of a task what no plan needs, without changing what plans it has or what they cost.
 */
final class Reduction {
  private Reduction() {}

  /**
   * The task without facts that always hold, operators that cannot be reached when nothing is
   * deleted, and operators that bring about nothing that anything else needs.
   *
   * @throws java.util.concurrent.CancellationException when patience is over
   */
  static GroundTask reduced(GroundTask task, GroundingBudget patience) {
    GroundTask before = task;
    while (true) {
      GroundTask reachable = withoutUnreachable(withoutConstants(before, patience), patience);
      GroundTask after = withoutIrrelevant(reachable, patience);
      if (after.operators().size() == before.operators().size()) {
        return after;
      }
      before = after;
    }
  }

  private static GroundTask withoutConstants(GroundTask task, GroundingBudget patience) {
    BitSet constant = new BitSet(task.facts());
    Arrays.stream(task.initial()).forEach(constant::set);
    for (GroundOperator operator : task.operators()) {
      patience.check();
      for (int fact : operator.deleted()) {
        constant.clear(fact);
      }
    }
    patience.refuseIfOver();
    if (constant.isEmpty()) {
      return task;
    }
    List<GroundOperator> operators = new ArrayList<>(task.operators().size());
    for (GroundOperator o : task.operators()) {
      patience.check();
      int[] needed = without(o.needed(), constant);
      int[] added = without(o.added(), constant);
      operators.add(
          needed.length == o.needed().length && added.length == o.added().length
              ? o
              : new GroundOperator(
                  o.schema(),
                  o.arguments(),
                  needed,
                  added,
                  o.deleted(),
                  o.bounds(),
                  o.changedSums(),
                  o.changes(),
                  o.cost()));
    }
    return new GroundTask(
        task.facts(),
        task.sums(),
        task.bounds(),
        operators,
        without(task.initial(), constant),
        without(task.goal(), constant),
        task.goalBounds(),
        task.unit(),
        task.unreachable(),
        task.names());
  }

  private static int[] without(int[] list, BitSet left) {
    for (int fact : list) {
      if (left.get(fact)) {
        return Arrays.stream(list).filter(kept -> !left.get(kept)).toArray();
      }
    }
    return list;
  }

  private static GroundTask withoutUnreachable(GroundTask task, GroundingBudget patience) {
    patience.refuseIfOver();
    List<GroundOperator> operators = task.operators();
    int[][] needed = operators.stream().map(GroundOperator::needed).toArray(int[][]::new);
    patience.refuseIfOver();
    int[][] consumers = SearchTask.inverse(needed, task.facts());
    patience.refuseIfOver();
    int[] open = Arrays.stream(needed).mapToInt(list -> list.length).toArray();
    BitSet reached = new BitSet(task.facts());
    Deque<Integer> queue = new ArrayDeque<>();
    for (int fact : task.initial()) {
      reached.set(fact);
      queue.add(fact);
    }
    BitSet applied = new BitSet(operators.size());
    for (int o = 0; o < open.length; o++) {
      patience.check();
      if (open[o] == 0) {
        apply(operators.get(o), o, applied, reached, queue);
      }
    }
    while (!queue.isEmpty()) {
      patience.check();
      for (int o : consumers[queue.remove()]) {
        if (--open[o] == 0) {
          apply(operators.get(o), o, applied, reached, queue);
        }
      }
    }
    return kept(task, applied);
  }

  private static void apply(
      GroundOperator operator, int o, BitSet applied, BitSet reached, Deque<Integer> queue) {
    applied.set(o);
    for (int fact : operator.added()) {
      if (!reached.get(fact)) {
        reached.set(fact);
        queue.add(fact);
      }
    }
  }

  private static GroundTask kept(GroundTask task, BitSet kept) {
    if (kept.cardinality() == task.operators().size()) {
      return task;
    }
    return task.withOperators(kept.stream().mapToObj(task.operators()::get).toList());
  }

  private static GroundTask withoutIrrelevant(GroundTask task, GroundingBudget patience) {
    patience.refuseIfOver();
    List<GroundOperator> operators = task.operators();
    int[][] added = operators.stream().map(GroundOperator::added).toArray(int[][]::new);
    patience.refuseIfOver();
    int[][] achievers = SearchTask.inverse(added, task.facts());
    BitSet relevant = new BitSet(operators.size());
    patience.refuseIfOver();
    BitSet wanted = new BitSet(task.facts());
    BitSet wantedSums = new BitSet();
    Deque<Integer> queue = new ArrayDeque<>();
    want(task, task.goal(), task.goalBounds(), wanted, wantedSums, queue);
    int sumsDone = -1;
    while (!queue.isEmpty() || sumsDone != wantedSums.cardinality()) {
      while (!queue.isEmpty()) {
        patience.check();
        for (int o : achievers[queue.remove()]) {
          if (!relevant.get(o)) {
            relevant.set(o);
            GroundOperator operator = operators.get(o);
            want(task, operator.needed(), operator.bounds(), wanted, wantedSums, queue);
          }
        }
      }
      sumsDone = wantedSums.cardinality();
      for (int o = 0; o < operators.size() && sumsDone > 0; o++) {
        patience.check();
        GroundOperator operator = operators.get(o);
        if (!relevant.get(o) && Arrays.stream(operator.changedSums()).anyMatch(wantedSums::get)) {
          relevant.set(o);
          want(task, operator.needed(), operator.bounds(), wanted, wantedSums, queue);
        }
      }
    }
    return kept(task, relevant);
  }

  private static void want(
      GroundTask task,
      int[] facts,
      int[] bounds,
      BitSet wanted,
      BitSet wantedSums,
      Deque<Integer> queue) {
    for (int fact : facts) {
      if (!wanted.get(fact)) {
        wanted.set(fact);
        queue.add(fact);
      }
    }
    for (int bound : bounds) {
      wantedSums.set(task.bounds().get(bound).sum());
    }
  }
}
