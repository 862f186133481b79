package org.maestro.coordination.recovery;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.Recovery;

/**
 * The parts that goals had before a restart, until whose part each was takes it up or gives it up.
 * The coordinator's thread only.
 */
public final class FormerParts {
  private final FormerCalls calls;
  private final Map<String, Recovery.UnfinishedGoal> unfinished = new TreeMap<>();
  private final Map<String, Recovery.EndedGoal> ended = new TreeMap<>();
  private final Set<String> taken = new HashSet<>();

  public FormerParts(Recovery recovery, FormerCalls calls) {
    this.calls = calls;
    for (Recovery.UnfinishedGoal goal : recovery.goals()) {
      goal.parts().forEach(part -> unfinished.put(part.id(), part));
      goal.endedParts().forEach(part -> ended.put(part.outcome().id(), part));
    }
  }

  /** What was under way for them. */
  public FormerCalls calls() {
    return calls;
  }

  /** How one has ended, if it did before the restart. */
  public Optional<GoalOutcome> outcome(String id) {
    return Optional.ofNullable(ended.get(id)).map(Recovery.EndedGoal::outcome);
  }

  /** One that had no end, with its own parts; empty when there was none. */
  public Optional<Recovery.UnfinishedGoal> takeUp(String id) {
    Optional<Recovery.UnfinishedGoal> goal = Optional.ofNullable(unfinished.get(id));
    if (goal.isPresent()) {
      taken.add(id);
    }
    return goal.map(one -> one.with(within(unfinished, id), within(ended, id)));
  }

  private static <T> List<T> within(Map<String, T> parts, String id) {
    List<T> within = new ArrayList<>();
    parts.forEach(
        (part, goal) -> {
          if (GoalId.isWithin(part, id)) {
            within.add(goal);
          }
        });
    return within;
  }

  /** Nobody goes on with it: what was under way for it, and for its parts, ends. */
  public void giveUp(String id, String why) {
    unfinished.values().stream()
        .filter(part -> part.id().equals(id) || GoalId.isWithin(part.id(), id))
        .forEach(part -> part.calls().forEach(call -> calls.giveUp(call, why)));
  }

  /** The same, of those parts of a goal with which nobody has gone on. */
  public void giveUpOthers(String goalId, String why) {
    unfinished.values().stream()
        .filter(part -> GoalId.isWithin(part.id(), goalId))
        .filter(part -> !taken.contains(part.id()))
        .filter(part -> taken.stream().noneMatch(one -> GoalId.isWithin(part.id(), one)))
        .forEach(part -> part.calls().forEach(call -> calls.giveUp(call, why)));
  }
}
