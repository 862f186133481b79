package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import org.maestro.sl.Term;

/**
 * The steps by which variables go from value to value, such as those of like robots through a
 * house, and shortest ways over them (Dijkstra, 1959).
 */
final class OwnGraph {
  private record Reached(Term value, double cost) {}

  private final Map<Optional<Term>, List<OwnStep>> stepsFrom = new HashMap<>();
  private final Map<Term, Map<Term, Double>> costsFrom = new HashMap<>();

  OwnGraph(List<OwnStep> steps) {
    steps.forEach(
        step -> stepsFrom.computeIfAbsent(step.from(), absent -> new ArrayList<>()).add(step));
  }

  /** Cost units from 0; infinite when there is no way. */
  double cost(Term from, Term to) {
    return costsFrom
        .computeIfAbsent(from, this::costsFrom)
        .getOrDefault(to, Double.POSITIVE_INFINITY);
  }

  private Map<Term, Double> costsFrom(Term first) {
    Map<Term, Double> costs = new HashMap<>();
    PriorityQueue<Reached> queue = new PriorityQueue<>(Comparator.comparingDouble(Reached::cost));
    reach(first, 0, costs, queue);
    follow(Optional.empty(), 0, costs, queue);
    while (!queue.isEmpty()) {
      Reached next = queue.remove();
      if (next.cost() == costs.getOrDefault(next.value(), Double.NaN)) {
        follow(Optional.of(next.value()), next.cost(), costs, queue);
      }
    }
    return costs;
  }

  private void follow(
      Optional<Term> from, double before, Map<Term, Double> costs, PriorityQueue<Reached> queue) {
    for (OwnStep step : stepsFrom.getOrDefault(from, List.of())) {
      reach(step.to(), before + step.cost(), costs, queue);
    }
  }

  private static void reach(
      Term value, double cost, Map<Term, Double> costs, PriorityQueue<Reached> queue) {
    if (cost < costs.getOrDefault(value, Double.POSITIVE_INFINITY)) {
      costs.put(value, cost);
      queue.add(new Reached(value, cost));
    }
  }
}
