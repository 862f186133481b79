package org.maestro.coordination;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * What a journal's entries amount to: what somebody who takes over has to know, and no more. Not
 * safe for use by several threads.
 */
public final class JournalImage {
  /** An entry and the clock's time at which it was written. */
  public record Dated(Duration at, JournalEntry entry) {}

  private static final class Goal {
    private final Dated submitted;
    private final Map<String, Call> calls = new LinkedHashMap<>();
    private Optional<Dated> became = Optional.empty();
    private int callsSince;
    private Optional<Dated> keeps = Optional.empty();
    private Optional<Dated> over = Optional.empty();

    private Goal(Dated submitted) {
      this.submitted = submitted;
    }
  }

  private static final class Call {
    private final Dated begun;
    private Optional<Dated> established = Optional.empty();
    private Optional<Dated> calledOff = Optional.empty();

    private Call(Dated begun) {
      this.begun = begun;
    }
  }

  private final Map<String, Goal> goals = new LinkedHashMap<>();
  private final Map<String, Dated> members = new TreeMap<>();
  private int lastGoalNumber;

  public JournalImage(int lastGoalNumber) {
    this.lastGoalNumber = lastGoalNumber;
  }

  public void add(Dated dated) {
    JournalEntry entry = dated.entry();
    if (entry instanceof JournalEntry.Submitted submitted) {
      goals.put(submitted.goalId(), new Goal(dated));
      lastGoalNumber = Math.max(lastGoalNumber, Coordinator.number(submitted.goalId()));
    } else if (entry instanceof JournalEntry.Became became) {
      goal(became.goalId())
          .ifPresent(
              goal -> {
                goal.became = Optional.of(dated);
                goal.callsSince = 0;
              });
    } else if (entry instanceof JournalEntry.Keeps keeps) {
      goal(keeps.goalId()).ifPresent(goal -> goal.keeps = Optional.of(dated));
    } else if (entry instanceof JournalEntry.Begun begun) {
      goal(begun.goalId())
          .ifPresent(
              goal -> {
                goal.calls.put(begun.call().id(), new Call(dated));
                goal.callsSince++;
              });
    } else if (entry instanceof JournalEntry.Established established) {
      call(established.goalId(), established.callId())
          .ifPresent(call -> call.established = Optional.of(dated));
    } else if (entry instanceof JournalEntry.CalledOff calledOff) {
      call(calledOff.goalId(), calledOff.callId())
          .ifPresent(call -> call.calledOff = Optional.of(dated));
    } else if (entry instanceof JournalEntry.Ended ended) {
      goal(ended.goalId()).ifPresent(goal -> goal.calls.remove(ended.callId()));
    } else if (entry instanceof JournalEntry.Over over) {
      goal(over.outcome().id()).ifPresent(goal -> goal.over = Optional.of(dated));
    } else if (entry instanceof JournalEntry.MemberCame came) {
      members.put(came.member(), dated);
    } else if (entry instanceof JournalEntry.MemberWent went) {
      members.remove(went.member());
    }
  }

  /** Forgets goals that ended before that time, and all but the latest so many that ended. */
  public void forgetEnded(Duration before, int most) {
    List<String> ended =
        goals.entrySet().stream()
            .filter(e -> e.getValue().over.isPresent())
            .sorted(Comparator.comparing(e -> e.getValue().over.orElseThrow().at()))
            .map(Map.Entry::getKey)
            .toList();
    for (int n = 0; n < ended.size(); n++) {
      boolean old = goals.get(ended.get(n)).over.orElseThrow().at().compareTo(before) < 0;
      if (old || n < ended.size() - most) {
        goals.remove(ended.get(n));
      }
    }
  }

  /** Forgets calls that were cancelled before that time: the members have heard it by now. */
  public void forgetCalledOff(Duration before) {
    for (Goal goal : goals.values()) {
      goal.calls
          .values()
          .removeIf(call -> call.calledOff.filter(at -> at.at().compareTo(before) < 0).isPresent());
    }
  }

  public int lastGoalNumber() {
    return lastGoalNumber;
  }

  /** The shortest list of entries that amounts to the same. */
  public List<Dated> entries() {
    List<Dated> entries = new ArrayList<>(members.values());
    for (Goal goal : goals.values()) {
      entries.add(goal.submitted);
      for (Call call : goal.calls.values()) {
        entries.add(call.begun);
        call.established.ifPresent(entries::add);
        call.calledOff.ifPresent(entries::add);
      }
      goal.became.map(became -> counted(goal, became)).ifPresent(entries::add);
      goal.keeps.ifPresent(entries::add);
      goal.over.ifPresent(entries::add);
    }
    return entries;
  }

  private static Dated counted(Goal goal, Dated became) {
    JournalEntry.Became entry = (JournalEntry.Became) became.entry();
    return new Dated(
        became.at(),
        new JournalEntry.Became(entry.goalId(), entry.state(), entry.reason(), effort(goal)));
  }

  private static GoalEffort effort(Goal goal) {
    GoalEffort effort =
        goal.became
            .map(became -> ((JournalEntry.Became) became.entry()).effort())
            .orElse(GoalEffort.NONE);
    return new GoalEffort(
        effort.plans(), effort.confirmingPlans(), effort.calls() + goal.callsSince);
  }

  public Recovery recovery() {
    List<Recovery.UnfinishedGoal> unfinished = new ArrayList<>();
    List<Recovery.EndedGoal> ended = new ArrayList<>();
    List<Recovery.UnfinishedCall> unwanted = new ArrayList<>();
    goals.forEach(
        (id, goal) -> {
          GoalRequest request = ((JournalEntry.Submitted) goal.submitted.entry()).request();
          List<Recovery.UnfinishedCall> wanted = new ArrayList<>();
          for (Call call : goal.calls.values()) {
            boolean isWanted = goal.over.isEmpty() && call.calledOff.isEmpty();
            (isWanted ? wanted : unwanted).add(unfinished(call));
          }
          if (goal.over.isPresent()) {
            JournalEntry.Over over = (JournalEntry.Over) goal.over.get().entry();
            ended.add(new Recovery.EndedGoal(request, over.outcome()));
          } else {
            unfinished.add(unfinished(id, request, goal, wanted));
          }
        });
    return new Recovery(
        lastGoalNumber, unfinished, ended, unwanted, new TreeSet<>(members.keySet()));
  }

  private static Recovery.UnfinishedCall unfinished(Call call) {
    return new Recovery.UnfinishedCall(
        (JournalEntry.Begun) call.begun.entry(), call.begun.at(), call.established.isPresent());
  }

  private static Recovery.UnfinishedGoal unfinished(
      String id, GoalRequest request, Goal goal, List<Recovery.UnfinishedCall> calls) {
    Optional<JournalEntry.Became> became =
        goal.became.map(dated -> (JournalEntry.Became) dated.entry());
    return new Recovery.UnfinishedGoal(
        id,
        request,
        goal.submitted.at(),
        became.map(JournalEntry.Became::state).orElse(GoalState.SUBMITTED),
        became.map(JournalEntry.Became::reason).orElse(""),
        effort(goal),
        goal.keeps
            .map(dated -> (JournalEntry.Keeps) dated.entry())
            .orElseGet(() -> JournalEntry.Keeps.nothing(id)),
        calls);
  }

  private Optional<Goal> goal(String id) {
    return Optional.ofNullable(goals.get(id));
  }

  private Optional<Call> call(String goalId, String callId) {
    return goal(goalId).map(goal -> goal.calls.get(callId));
  }
}
