package org.maestro.coordination.story;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;

/**
 * The latest plans of one goal, with all that they were chosen from. Facts and prices of a plan are
 * much to keep: so only a few plans are, of large tasks the latest alone, and none beyond the end
 * of the process.
 */
public final class Decisions {
  private static final int MOST = 5;
  private static final long MOST_BYTES = 256 << 10;

  private final Map<Integer, Decision> byPlan = new LinkedHashMap<>();

  /**
   * @param plan its number in the goal's story
   */
  public void add(int plan, Decision decision) {
    byPlan.put(plan, decision);
    while (byPlan.size() > MOST || byPlan.size() > 1 && bytes() > MOST_BYTES) {
      byPlan.remove(byPlan.keySet().iterator().next());
    }
  }

  /** What they take of memory, about. */
  public long bytes() {
    return byPlan.values().stream().mapToLong(Decision::bytes).sum();
  }

  /** Of the plan with that number, of the latest one without. */
  public Optional<Decision> find(OptionalInt plan) {
    return plan.isPresent()
        ? Optional.ofNullable(byPlan.get(plan.getAsInt()))
        : byPlan.values().stream().reduce((earlier, later) -> later);
  }

  /** Why nothing can be said of that step. */
  public String whyNot(String goalId, OptionalInt plan, int step) {
    if (byPlan.isEmpty()) {
      return ("Of %s no plan is kept: what plans were chosen from is kept of the latest goals only,"
              + " and not beyond a restart; the story is.")
          .formatted(goalId);
    }
    if (find(plan).isEmpty()) {
      return "Of %s these plans are kept: %s; plan %d is not."
          .formatted(
              goalId,
              byPlan.keySet().stream().map(String::valueOf).collect(Collectors.joining(", ")),
              plan.getAsInt());
    }
    return plan.isPresent()
        ? "Plan %d of %s has no step %d.".formatted(plan.getAsInt(), goalId, step)
        : "The latest plan of %s has no step %d.".formatted(goalId, step);
  }
}
