package org.maestro.planning.api;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.maestro.sl.Effect;

/**
 * The makespan of a plan as it is executed: a step begins when those before it are done, and,
 * unless some sensing needs it, when all sensing is done.
 */
public final class PlanTime {
  private PlanTime() {}

  /** Seconds from the first step's beginning to the last one's end. */
  static double seconds(List<Step> steps) {
    Map<Integer, Double> starts = starts(steps);
    return steps.stream()
        .mapToDouble(step -> Objects.requireNonNull(starts.get(step.number())) + step.seconds())
        .max()
        .orElse(0);
  }

  /** Seconds from the first step's beginning to that of each, by its number. */
  static Map<Integer, Double> starts(List<Step> steps) {
    Map<Integer, Set<Integer>> before = new HashMap<>();
    Set<Integer> serving = new HashSet<>();
    for (Step step : steps) {
      Set<Integer> all = new HashSet<>(step.after());
      step.after().forEach(number -> all.addAll(before.get(number)));
      before.put(step.number(), all);
      if (senses(step.feature().effect())) {
        serving.add(step.number());
        serving.addAll(all);
      }
    }
    Map<Integer, Double> starts = new HashMap<>();
    Map<Integer, Double> end = new HashMap<>();
    double sensed = 0;
    for (boolean first : new boolean[] {true, false}) {
      for (Step step : steps) {
        if (serving.contains(step.number()) == first) {
          double start = first ? 0 : sensed;
          for (int number : step.after()) {
            start = Math.max(start, Objects.requireNonNull(end.get(number)));
          }
          starts.put(step.number(), start);
          end.put(step.number(), start + step.seconds());
        }
      }
      sensed = end.values().stream().mapToDouble(Double::doubleValue).max().orElse(0);
    }
    return starts;
  }

  /** Whether the steps of a feature count as sensing. */
  public static boolean senses(Effect effect) {
    return effect instanceof Effect.All all
        ? all.effects().stream().anyMatch(PlanTime::senses)
        : effect instanceof Effect.SenseAtom || effect instanceof Effect.SenseNumber;
  }
}
