package org.maestro.coordination.contention;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.coordination.facts.Sensing;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Step;

/**
 * The order in which the steps of a plan may start. A step waits for those before it. As plans hope
 * that sensing finds what is sought, a step that no sensing needs also waits until all sensing is
 * done that does not need it: nobody drives off before it is known that it is worth it.
 */
final class ExecutionOrder {
  private final Plan plan;
  private final Map<Integer, Set<Integer>> before = new TreeMap<>();

  ExecutionOrder(Plan plan) {
    this.plan = plan;
    for (Step step : plan.steps()) {
      Set<Integer> all = new HashSet<>(step.after());
      step.after().forEach(number -> all.addAll(before.getOrDefault(number, Set.of())));
      before.put(step.number(), all);
    }
  }

  /**
   * @param done numbers of the steps that are done
   */
  List<Step> startable(Set<Integer> done) {
    return presentPart(done).stream().filter(step -> done.containsAll(step.after())).toList();
  }

  /** The steps left that serve sensing that is left; without such, all that are left. */
  List<Step> presentPart(Set<Integer> done) {
    List<Step> left = plan.steps().stream().filter(step -> !done.contains(step.number())).toList();
    List<Step> sensingLeft =
        left.stream().filter(step -> Sensing.isIn(step.feature().effect())).toList();
    return left.stream()
        .filter(step -> sensingLeft.isEmpty() || serves(step, sensingLeft))
        .toList();
  }

  private Set<Integer> allBefore(Step step) {
    return Objects.requireNonNull(before.get(step.number()));
  }

  private boolean serves(Step step, List<Step> sensingLeft) {
    return sensingLeft.stream()
        .anyMatch(
            sensing ->
                sensing.number() == step.number() || allBefore(sensing).contains(step.number()));
  }
}
