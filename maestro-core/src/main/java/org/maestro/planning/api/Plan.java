package org.maestro.planning.api;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.sl.Term;

/**
 * A plan, cheapest for the prices given. Empty when the goal holds already. Where it looks for what
 * nobody knows, it counts on finding it; it begins where that is expected to cost least.
 *
 * @param cost when all is found where it is looked for
 * @param goalBinding values of the goal's free variables
 * @param searches what it looks for, and where else that could have begun
 */
public record Plan(
    List<Step> steps, double cost, Map<String, Term> goalBinding, List<PlannedSearch> searches) {
  public Plan {
    steps = List.copyOf(steps);
    searches = List.copyOf(searches);
  }

  /** A plan that has nothing to choose where to look. */
  public Plan(List<Step> steps, double cost, Map<String, Term> goalBinding) {
    this(steps, cost, goalBinding, List.of());
  }

  /** From the first step's beginning to the last one's end, as it is executed; seconds. */
  public double seconds() {
    return PlanTime.seconds(steps);
  }

  /** When each step begins, by its number; seconds from the first one's beginning. */
  public Map<Integer, Double> starts() {
    return PlanTime.starts(steps);
  }

  /** Whoever has a step in it, in the order of the steps. */
  public Set<String> members() {
    Set<String> members = new LinkedHashSet<>();
    steps.forEach(step -> members.add(step.member()));
    return members;
  }

  public Plan withSearches(List<PlannedSearch> planned) {
    return new Plan(steps, cost, goalBinding, planned);
  }
}
