package org.maestro.coordination.contention;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Step;
import org.maestro.sl.Term;

/** The plan that a goal follows now, and which of its steps are done. */
public final class PlanUnderway {
  private Optional<Plan> plan = Optional.empty();
  private final Set<Integer> done = new LinkedHashSet<>();

  public void adopt(Plan adopted) {
    plan = Optional.of(adopted);
    done.clear();
  }

  public void drop() {
    plan = Optional.empty();
    done.clear();
  }

  public boolean exists() {
    return plan.isPresent();
  }

  public int size() {
    return steps().size();
  }

  /** Those whose predecessors are done, begun or not. */
  public List<Step> startable() {
    return plan.map(p -> new ExecutionOrder(p).startable(done)).orElse(List.of());
  }

  /** The remaining steps that the looks left depend on; once all looks are done, all the rest. */
  List<Step> presentPart() {
    return plan.map(p -> new ExecutionOrder(p).presentPart(done)).orElse(List.of());
  }

  /** What remains, and done steps on whose outcome a remaining one builds directly. */
  List<Step> needed() {
    List<Step> remaining = remaining();
    return steps().stream()
        .filter(
            step ->
                !done.contains(step.number())
                    || remaining.stream().anyMatch(next -> next.after().contains(step.number())))
        .toList();
  }

  boolean hasBegun() {
    return !done.isEmpty();
  }

  public List<Step> remaining() {
    return steps().stream().filter(step -> !done.contains(step.number())).toList();
  }

  /** A plan made meanwhile may want a step that an earlier one began. */
  public void done(Step ended) {
    remaining().stream()
        .filter(step -> step.key().equals(ended.key()))
        .findFirst()
        .ifPresent(step -> done.add(step.number()));
  }

  Map<String, Term> goalBinding() {
    return plan.map(Plan::goalBinding).orElse(Map.of());
  }

  private List<Step> steps() {
    return plan.map(Plan::steps).orElse(List.of());
  }
}
