package org.maestro.planning.unsolvable;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.ground.Schema;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;

/**
 * Finds parts of a goal that cannot be reached together, and of which none can be left out: each is
 * left out in turn, and what then is proven to have no plan still has the conflict.
 */
final class GoalConflict {
  private static final double SECONDS_EACH = 2;

  private final LiftedTask task;
  private final Schema goal;
  private final GroundingBudget patience;

  GoalConflict(LiftedTask task, Schema goal, GroundingBudget patience) {
    this.task = task;
    this.goal = goal;
    this.patience = patience;
  }

  /** Empty where the goal is about objects that it does not name. */
  Optional<String> sentence() {
    int literals = goal.conditions().size();
    if (!goal.domains().isEmpty()) {
      return Optional.empty();
    }
    List<Integer> parts =
        new ArrayList<>(IntStream.range(0, literals + goal.comparisons().size()).boxed().toList());
    boolean isSure = true;
    for (Integer part : List.copyOf(parts)) {
      List<Integer> others = new ArrayList<>(parts);
      others.remove(part);
      Solution.Verdict verdict = others.isEmpty() ? Solution.Verdict.OPTIMAL : verdict(others);
      if (verdict == Solution.Verdict.UNSOLVABLE) {
        parts = others;
      }
      isSure &=
          verdict != Solution.Verdict.OUT_OF_TIME && verdict != Solution.Verdict.OUT_OF_MEMORY;
    }
    return Optional.of(sentence(parts.stream().map(this::words).toList(), isSure));
  }

  private static String sentence(List<String> parts, boolean isSure) {
    String all = String.join(" and ", parts);
    return switch (parts.size()) {
      case 0 -> "the goal contradicts what no step changes";
      case 1 -> "needed: %s; no order of steps brings it about".formatted(all);
      default ->
          "needed together: %s; %s"
              .formatted(
                  all,
                  isSure
                      ? "without any one of them there is a plan"
                      : "no order of steps brings them about");
    };
  }

  private Solution.Verdict verdict(List<Integer> parts) {
    LiftedTask smaller =
        new LiftedTask(
            task.objects(),
            task.predicates(),
            task.functions(),
            task.schemas(),
            task.initial(),
            task.values(),
            List.of(goalOf(parts)),
            task.metric());
    GroundingBudget each = patience.atMost(SECONDS_EACH);
    long memory = Runtime.getRuntime().maxMemory() / 10 * 6;
    return new AnytimePlanner(Grounder.growing(smaller, each), memory, line -> {})
        .first(each)
        .verdict();
  }

  private Schema goalOf(List<Integer> parts) {
    int literals = goal.conditions().size();
    return new Schema(
        goal.name(),
        goal.place(),
        goal.domains(),
        goal.shown(),
        parts.stream().filter(part -> part < literals).map(goal.conditions()::get).toList(),
        goal.differences(),
        parts.stream()
            .filter(part -> part >= literals)
            .map(part -> goal.comparisons().get(part - literals))
            .toList(),
        List.of(),
        List.of(),
        List.of());
  }

  private String words(int part) {
    int literals = goal.conditions().size();
    int[] none = {};
    return part < literals
        ? new Words(task).literal(goal.conditions().get(part), none)
        : new Words(task).comparison(goal.comparisons().get(part - literals), none);
  }
}
