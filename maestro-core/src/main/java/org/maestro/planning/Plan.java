package org.maestro.planning;

import java.util.List;
import java.util.Map;
import org.maestro.sl.Term;

/**
 * A plan, cheapest for the prices given. Empty when the goal holds already.
 *
 * @param goalBinding values of the goal's free variables
 */
public record Plan(List<Step> steps, double cost, Map<String, Term> goalBinding) {
  public Plan {
    steps = List.copyOf(steps);
  }
}
