package org.maestro.planning;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.PriorityQueue;
import java.util.function.Function;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Successors;

/**
 * Uniform-cost search over all ground operators, without relevance, pruning or heuristic: slow and
 * simple.
 */
public final class ExhaustiveSearch {
  private record Entry(double cost, State state) {}

  private ExhaustiveSearch() {}

  /**
   * The cost of the cheapest plan, empty when there is none, NaN when there are too many states to
   * say.
   */
  public static OptionalDouble cheapest(GroundProblem problem, int mostStates) {
    return cheapest(problem, mostStates, state -> problem.operators());
  }

  /**
   * The same, where from each state it goes on with some operators only.
   *
   * @param going also with operators that are not possible in the state
   */
  public static OptionalDouble cheapest(
      GroundProblem problem, int mostStates, Function<State, List<Operator>> going) {
    PriorityQueue<Entry> queue = new PriorityQueue<>((a, b) -> Double.compare(a.cost(), b.cost()));
    Map<State, Double> best = new HashMap<>();
    queue.add(new Entry(0, problem.initial()));
    best.put(problem.initial(), 0.0);
    while (!queue.isEmpty()) {
      Entry entry = queue.remove();
      if (entry.cost() > best.get(entry.state())) {
        continue;
      }
      if (problem.goal().condition().holds(entry.state())) {
        return OptionalDouble.of(entry.cost());
      }
      if (best.size() > mostStates) {
        return OptionalDouble.of(Double.NaN);
      }
      for (Operator operator : going.apply(entry.state())) {
        if (Successors.isApplicable(operator, entry.state())) {
          State after = Successors.after(operator, entry.state());
          double cost = entry.cost() + operator.price().cost(entry.state().numbers());
          if (cost < best.getOrDefault(after, Double.POSITIVE_INFINITY) - 1e-9) {
            best.put(after, cost);
            queue.add(new Entry(cost, after));
          }
        }
      }
    }
    return OptionalDouble.empty();
  }
}
