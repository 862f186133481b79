package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundingBudget;

/**
 * The facts and sums of a task in groups such that every operator changes those of one group only:
 * a robot's place, a room's light, where all things are.
 */
final class Components {
  /**
   * A group.
   *
   * @param operators those that change it
   * @param needed the other groups that these operators look at
   */
  record Component(int[] facts, int[] sums, int[] operators, TreeSet<Integer> needed) {}

  private final SearchTask task;
  private final int[] leader;
  private final int[] componentOf;
  private final List<Component> components = new ArrayList<>();

  /**
   * @throws java.util.concurrent.CancellationException when patience is over
   */
  Components(SearchTask task, GroundingBudget patience) {
    this.task = task;
    int things = task.facts + task.origin.sums().length;
    leader = new int[things];
    Arrays.setAll(leader, i -> i);
    int[] first = new int[task.operators.size()];
    for (int o = 0; o < first.length; o++) {
      patience.check();
      int[] changed = changed(o);
      first[o] = changed.length == 0 ? -1 : changed[0];
      for (int thing : changed) {
        leader[find(thing)] = find(changed[0]);
      }
    }
    Map<Integer, Integer> numbers = new LinkedHashMap<>();
    componentOf = new int[things];
    for (int thing = 0; thing < things; thing++) {
      componentOf[thing] = numbers.computeIfAbsent(find(thing), absent -> numbers.size());
    }
    List<List<Integer>> members = new ArrayList<>();
    List<List<Integer>> operators = new ArrayList<>();
    for (int c = 0; c < numbers.size(); c++) {
      members.add(new ArrayList<>());
      operators.add(new ArrayList<>());
    }
    for (int thing = 0; thing < things; thing++) {
      members.get(componentOf[thing]).add(thing);
    }
    for (int o = 0; o < first.length; o++) {
      if (first[o] >= 0) {
        operators.get(componentOf[first[o]]).add(o);
      }
    }
    for (int c = 0; c < numbers.size(); c++) {
      patience.check();
      TreeSet<Integer> needed = new TreeSet<>();
      for (int o : operators.get(c)) {
        for (int fact : task.needed[o]) {
          needed.add(componentOf[fact]);
        }
        for (int bound : task.operators.get(o).bounds()) {
          needed.add(componentOfSum(task.origin.bounds().get(bound).sum()));
        }
      }
      needed.remove(c);
      components.add(
          new Component(
              members.get(c).stream().filter(t -> t < task.facts).mapToInt(t -> t).toArray(),
              members.get(c).stream()
                  .filter(t -> t >= task.facts)
                  .mapToInt(t -> t - task.facts)
                  .toArray(),
              operators.get(c).stream().mapToInt(o -> o).toArray(),
              needed));
    }
  }

  List<Component> all() {
    return components;
  }

  int componentOf(int fact) {
    return componentOf[fact];
  }

  int componentOfSum(int sum) {
    return componentOf[task.facts + sum];
  }

  private int[] changed(int o) {
    GroundOperator operator = task.operators.get(o);
    int[] added = task.added[o];
    int[] deleted = task.deleted[o];
    int[] sums = operator.changedSums();
    int[] changed = new int[added.length + deleted.length + sums.length];
    System.arraycopy(added, 0, changed, 0, added.length);
    System.arraycopy(deleted, 0, changed, added.length, deleted.length);
    for (int i = 0; i < sums.length; i++) {
      changed[added.length + deleted.length + i] = task.facts + sums[i];
    }
    return changed;
  }

  private int find(int thing) {
    int root = thing;
    while (leader[root] != root) {
      root = leader[root];
    }
    for (int at = thing; leader[at] != root; ) {
      int next = leader[at];
      leader[at] = root;
      at = next;
    }
    return root;
  }
}
