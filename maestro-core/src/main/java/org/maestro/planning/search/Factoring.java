package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.search.Components.Component;

/**
 * The choice of those components of a task that become leaves: none of them looks at another, so
 * that only the rest, the centre, has to be searched. Components that have few neighbours, many
 * states and operators that look at nothing else come first.
 */
final class Factoring {
  private static final int MOST_STATES = 4000;

  private final SearchTask task;
  private final GroundingBudget patience;
  private final Components components;
  private final List<Set<Integer>> neighbours = new ArrayList<>();

  private Factoring(SearchTask task, GroundingBudget patience) {
    this.task = task;
    this.patience = patience;
    components = new Components(task, patience);
    for (int c = 0; c < components.all().size(); c++) {
      neighbours.add(new HashSet<>());
    }
    for (int c = 0; c < neighbours.size(); c++) {
      for (int other : components.all().get(c).needed()) {
        neighbours.get(c).add(other);
        neighbours.get(other).add(c);
      }
    }
  }

  /**
   * The leaves.
   *
   * @param below plans that cost this much or more do not matter
   */
  static List<Leaf> leaves(SearchTask task, long below, GroundingBudget patience) {
    return new Factoring(task, patience).choose(below);
  }

  private List<Leaf> choose(long below) {
    TreeMap<Integer, LeafSpace> left = new TreeMap<>();
    for (int c = 0; c < components.all().size(); c++) {
      Component component = components.all().get(c);
      if (component.operators().length > 0 && looksAtNoForeignSum(c)) {
        explore(component, below).ifPresent(putInto(left, c));
      }
    }
    List<Leaf> leaves = new ArrayList<>();
    while (!left.isEmpty()) {
      Map.Entry<Integer, LeafSpace> best =
          left.entrySet().stream()
              .max(
                  Comparator.comparingDouble(
                          (Map.Entry<Integer, LeafSpace> space) ->
                              worth(space.getKey(), space.getValue(), left))
                      .thenComparing(Map.Entry.comparingByKey(Comparator.reverseOrder())))
              .orElseThrow();
      if (best.getValue().size() > 1) {
        leaves.add(new Leaf(task, best.getValue()));
      }
      int component = best.getKey();
      left.remove(component);
      left.keySet().removeAll(neighbours.get(component));
    }
    return leaves;
  }

  private static java.util.function.Consumer<LeafSpace> putInto(
      Map<Integer, LeafSpace> spaces, int component) {
    return space -> spaces.put(component, space);
  }

  private boolean looksAtNoForeignSum(int c) {
    Component component = components.all().get(c);
    for (int o : component.operators()) {
      for (int bound : task.operators.get(o).bounds()) {
        if (components.componentOfSum(task.origin.bounds().get(bound).sum()) != c) {
          return false;
        }
      }
    }
    return true;
  }

  /** States that are dearer than what is left beside all other costs are left out. */
  private Optional<LeafSpace> explore(Component component, long below) {
    long[] others = task.cost.clone();
    for (int o : component.operators()) {
      others[o] = 0;
    }
    long elsewhere = new LandmarkCuts(task, others, patience).estimate(task.initial);
    if (elsewhere >= below) {
      return Optional.empty();
    }
    return LeafSpace.explore(task, component, below - elsewhere, MOST_STATES, patience);
  }

  private double worth(int c, LeafSpace space, Map<Integer, LeafSpace> left) {
    Component component = components.all().get(c);
    int inside = 0;
    for (int o : component.operators()) {
      patience.check();
      inside += Arrays.stream(task.needed[o]).allMatch(f -> components.componentOf(f) == c) ? 1 : 0;
    }
    double lost = 1;
    for (int other : neighbours.get(c)) {
      LeafSpace beside = left.get(other);
      if (beside != null) {
        lost += Math.log(1 + beside.size());
      }
    }
    double free = 0.1 + (double) inside / component.operators().length;
    return Math.log(1 + space.size()) * free / lost;
  }
}
