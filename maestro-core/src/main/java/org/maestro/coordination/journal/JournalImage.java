package org.maestro.coordination.journal;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Recovery;

/**
 * The state to which a journal's entries amount: what somebody who takes over has to know, and no
 * more. Not safe for use by several threads.
 */
public final class JournalImage {
  /** An entry and the clock's time at which it was written. */
  public record Dated(Duration at, JournalEntry entry) {}

  private final Map<String, GoalImage> goals = new LinkedHashMap<>();
  private final Map<String, Dated> members = new TreeMap<>();
  private int lastGoalNumber;

  public JournalImage(int lastGoalNumber) {
    this.lastGoalNumber = lastGoalNumber;
  }

  /**
   * What entries that amount to this recovery would amount to.
   *
   * @param now the time of what has none of its own
   */
  public static JournalImage of(Recovery recovery, Duration now) {
    JournalImage image = new JournalImage(recovery.lastGoalNumber());
    recovery
        .members()
        .forEach(m -> image.add(new Dated(now, new JournalEntry.MemberCame(m, Optional.empty()))));
    for (Recovery.UnfinishedGoal goal : recovery.goals()) {
      image.submitted(goal);
    }
    recovery.ended().forEach(image::ended);
    for (Recovery.UnfinishedCall call : recovery.unwanted()) {
      image.add(new Dated(call.begunAt(), call.begun()));
      image.add(
          new Dated(
              now, new JournalEntry.CalledOff(call.begun().goalId(), call.begun().call().id())));
    }
    for (Recovery.UnfinishedGoal goal : recovery.goals()) {
      GoalImage.entries(goal, now).forEach(image::add);
      goal.parts().forEach(image::submitted);
      goal.parts().forEach(part -> GoalImage.entries(part, now).forEach(image::add));
      goal.endedParts().forEach(image::ended);
    }
    return image;
  }

  private void submitted(Recovery.UnfinishedGoal goal) {
    add(new Dated(goal.submittedAt(), new JournalEntry.Submitted(goal.id(), goal.request())));
  }

  private void ended(Recovery.EndedGoal goal) {
    Duration submitted = goal.outcome().submittedAt();
    add(new Dated(submitted, new JournalEntry.Submitted(goal.outcome().id(), goal.request())));
    add(new Dated(goal.outcome().endedAt(), new JournalEntry.Over(goal.outcome())));
  }

  public void add(Dated dated) {
    JournalEntry entry = dated.entry();
    if (entry instanceof JournalEntry.Submitted submitted) {
      goals.put(submitted.goalId(), new GoalImage(dated));
      forgetParts(submitted.goalId() + ".");
      lastGoalNumber = Math.max(lastGoalNumber, GoalId.number(GoalId.CENTRAL, submitted.goalId()));
    } else if (entry instanceof JournalEntry.Withdrawn withdrawn) {
      goals.remove(withdrawn.goalId());
    } else if (entry instanceof JournalEntry.OfGoal ofGoal) {
      Optional.ofNullable(goals.get(ofGoal.goalId())).ifPresent(goal -> goal.add(dated));
      if (entry instanceof JournalEntry.Noted noted) {
        forgetParts(GoalId.part(noted.goalId(), noted.path()) + ".");
      } else if (entry instanceof JournalEntry.Over) {
        forgetParts(ofGoal.goalId() + ".");
      }
    } else if (entry instanceof JournalEntry.MemberCame came) {
      members.put(came.member(), dated);
    } else if (entry instanceof JournalEntry.MemberWent went) {
      members.remove(went.member());
    }
  }

  /** What became of them is of no use any more, but calls that nobody wants. */
  private void forgetParts(String idsBegin) {
    goals
        .entrySet()
        .removeIf(
            goal -> goal.getKey().startsWith(idsBegin) && goal.getValue().unwanted().isEmpty());
  }

  /** Whether a script that is not over will want to know how a part of it has ended. */
  private boolean isWanted(String goalId) {
    return GoalId.isPart(goalId)
        && Optional.ofNullable(goals.get(GoalId.whole(goalId)))
            .filter(whole -> whole.overSince().isEmpty())
            .isPresent();
  }

  /**
   * Forgets goals that ended before that time, and all but the latest that ended that fit into so
   * many bytes of memory.
   */
  public void forgetEnded(Duration before, long mostBytes) {
    List<Map.Entry<String, GoalImage>> ended =
        goals.entrySet().stream()
            .filter(e -> e.getValue().overSince().isPresent() && !isWanted(e.getKey()))
            .sorted(Comparator.comparing(e -> e.getValue().overSince().orElseThrow()))
            .toList();
    long bytes = ended.stream().mapToLong(e -> e.getValue().bytes()).sum();
    for (Map.Entry<String, GoalImage> goal : ended) {
      boolean old = goal.getValue().overSince().orElseThrow().compareTo(before) < 0;
      if (old || bytes > mostBytes) {
        bytes -= goal.getValue().bytes();
        goals.remove(goal.getKey());
      }
    }
  }

  /** Forgets calls that were cancelled before that time: the members have heard it by now. */
  public void forgetCalledOff(Duration before) {
    goals.values().forEach(goal -> goal.forgetCalledOff(before));
  }

  public int lastGoalNumber() {
    return lastGoalNumber;
  }

  /** The shortest list of entries that amounts to the same. */
  public List<Dated> entries() {
    List<Dated> entries = new ArrayList<>(members.values());
    goals.values().forEach(goal -> entries.addAll(goal.entries()));
    return entries;
  }

  private Recovery.UnfinishedGoal unfinished(String id, GoalImage goal) {
    List<Recovery.UnfinishedGoal> parts = new ArrayList<>();
    List<Recovery.EndedGoal> endedParts = new ArrayList<>();
    goals.forEach(
        (partId, part) -> {
          if (partId.startsWith(id + ".")) {
            part.ended()
                .ifPresentOrElse(
                    endedParts::add, () -> parts.add(part.unfinished(List.of(), List.of())));
          }
        });
    return goal.unfinished(parts, endedParts);
  }

  public Recovery recovery() {
    List<Recovery.UnfinishedGoal> unfinished = new ArrayList<>();
    List<Recovery.EndedGoal> ended = new ArrayList<>();
    List<Recovery.UnfinishedCall> unwanted = new ArrayList<>();
    goals.forEach(
        (id, goal) -> {
          unwanted.addAll(goal.unwanted());
          if (!GoalId.isPart(id)) {
            goal.ended().ifPresentOrElse(ended::add, () -> unfinished.add(unfinished(id, goal)));
          }
        });
    return new Recovery(
        lastGoalNumber, unfinished, ended, unwanted, new TreeSet<>(members.keySet()));
  }
}
