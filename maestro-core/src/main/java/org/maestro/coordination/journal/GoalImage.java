package org.maestro.coordination.journal;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.coordination.api.GoalEffort;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.journal.JournalImage.Dated;
import org.maestro.planning.api.StepKey;

/**
 * The state to which a journal's entries about one goal amount. Not safe for use by several
 * threads.
 */
final class GoalImage {
  private static final class Call {
    private final Dated begun;
    private Optional<Dated> established = Optional.empty();
    private Optional<Dated> calledOff = Optional.empty();

    private Call(Dated begun) {
      this.begun = begun;
    }

    private Recovery.UnfinishedCall unfinished() {
      return new Recovery.UnfinishedCall(
          (JournalEntry.Begun) begun.entry(), begun.at(), established.isPresent());
    }
  }

  private static final long BYTES = 1_024;

  private final Dated submitted;
  private final Map<String, Call> calls = new LinkedHashMap<>();
  private final Map<StepKey, Dated> failures = new LinkedHashMap<>();
  private final List<Dated> looks = new ArrayList<>();
  private Optional<Dated> held = Optional.empty();
  private Optional<Dated> became = Optional.empty();
  private int callsSince;
  private Optional<Dated> keeps = Optional.empty();
  private Optional<Dated> settings = Optional.empty();
  private Optional<Dated> asked = Optional.empty();
  private Optional<Dated> over = Optional.empty();
  private Optional<Dated> lastEnd = Optional.empty();
  private final Map<String, Dated> notes = new LinkedHashMap<>();

  /**
   * @param submitted a {@link JournalEntry.Submitted}
   */
  GoalImage(Dated submitted) {
    this.submitted = submitted;
  }

  /** Entries that amount to what became of this goal since it was submitted. */
  static List<Dated> entries(Recovery.UnfinishedGoal goal, Duration now) {
    List<JournalEntry> later = new ArrayList<>();
    List<Dated> entries = new ArrayList<>();
    for (Recovery.UnfinishedCall call : goal.calls()) {
      entries.add(new Dated(call.begunAt(), call.begun()));
      if (call.established()) {
        later.add(new JournalEntry.Established(goal.id(), call.begun().call().id()));
      }
    }
    if (goal.memory().everHeld()) {
      later.add(new JournalEntry.Became(goal.id(), GoalState.HOLDING, "", goal.effort()));
    }
    later.add(new JournalEntry.Became(goal.id(), goal.state(), goal.detail(), goal.effort()));
    later.add(goal.keeps());
    later.addAll(goal.memory().failures());
    later.addAll(goal.memory().looks());
    later.add(new JournalEntry.Settings(goal.id(), goal.memory().settings()));
    goal.memory().asked().ifPresent(later::add);
    later.addAll(goal.memory().notes());
    goal.lastEnd().ifPresent(later::add);
    later.forEach(entry -> entries.add(new Dated(now, entry)));
    return entries;
  }

  void add(Dated dated) {
    JournalEntry entry = dated.entry();
    if (entry instanceof JournalEntry.Became state) {
      became = Optional.of(dated);
      callsSince = 0;
      if (state.state() == GoalState.HOLDING && held.isEmpty()) {
        held = became;
      }
    } else if (entry instanceof JournalEntry.Keeps) {
      keeps = Optional.of(dated);
    } else if (entry instanceof JournalEntry.Begun begun) {
      calls.put(begun.call().id(), new Call(dated));
      callsSince++;
    } else if (entry instanceof JournalEntry.Established established) {
      call(established.callId()).ifPresent(call -> call.established = Optional.of(dated));
    } else if (entry instanceof JournalEntry.CalledOff calledOff) {
      call(calledOff.callId()).ifPresent(call -> call.calledOff = Optional.of(dated));
    } else if (entry instanceof JournalEntry.NotBegun notBegun) {
      calls.remove(notBegun.callId());
    } else if (entry instanceof JournalEntry.Ended ended) {
      calls.remove(ended.callId());
      lastEnd = Optional.of(dated);
    } else if (entry instanceof JournalEntry.Failed failed) {
      failures.put(failed.step(), dated);
    } else if (entry instanceof JournalEntry.LookedInVain) {
      looks.add(dated);
    } else if (entry instanceof JournalEntry.Settings) {
      settings = Optional.of(dated);
    } else if (entry instanceof JournalEntry.Asked) {
      asked = Optional.of(dated);
    } else if (entry instanceof JournalEntry.Noted noted) {
      notes.keySet().removeIf(path -> path.startsWith(noted.path() + "."));
      notes.put(noted.path(), dated);
    } else if (entry instanceof JournalEntry.AttemptOver) {
      forgetAttempt();
    } else if (entry instanceof JournalEntry.Over) {
      over = Optional.of(dated);
      held = Optional.empty();
      settings = Optional.empty();
      notes.clear();
      lastEnd = Optional.empty();
      forgetAttempt();
    }
  }

  private void forgetAttempt() {
    keeps = Optional.empty();
    failures.clear();
    looks.clear();
  }

  private Optional<Call> call(String id) {
    return Optional.ofNullable(calls.get(id));
  }

  /** What it takes of memory when it is over, about. */
  long bytes() {
    return BYTES + ended().map(goal -> goal.outcome().bytes()).orElse(0L);
  }

  Optional<Duration> overSince() {
    return over.map(Dated::at);
  }

  void forgetCalledOff(Duration before) {
    calls
        .values()
        .removeIf(call -> call.calledOff.filter(at -> at.at().compareTo(before) < 0).isPresent());
  }

  /** The shortest list of entries that amounts to the same. */
  List<Dated> entries() {
    List<Dated> entries = new ArrayList<>();
    entries.add(submitted);
    for (Call call : calls.values()) {
      entries.add(call.begun);
      call.established.ifPresent(entries::add);
      call.calledOff.ifPresent(entries::add);
    }
    held.ifPresent(entries::add);
    became.map(this::counted).ifPresent(entries::add);
    keeps.ifPresent(entries::add);
    entries.addAll(failures.values());
    entries.addAll(looks);
    settings.ifPresent(entries::add);
    asked.ifPresent(entries::add);
    entries.addAll(notes.values());
    lastEnd.ifPresent(entries::add);
    over.ifPresent(entries::add);
    return entries;
  }

  private Dated counted(Dated state) {
    JournalEntry.Became entry = (JournalEntry.Became) state.entry();
    return new Dated(
        state.at(),
        new JournalEntry.Became(entry.goalId(), entry.state(), entry.reason(), effort()));
  }

  private GoalEffort effort() {
    GoalEffort effort =
        became.map(state -> ((JournalEntry.Became) state.entry()).effort()).orElse(GoalEffort.NONE);
    return new GoalEffort(effort.plans(), effort.confirmingPlans(), effort.calls() + callsSince);
  }

  private GoalRequest request() {
    return ((JournalEntry.Submitted) submitted.entry()).request();
  }

  /** How it ended, if it did. */
  Optional<Recovery.EndedGoal> ended() {
    return over.map(
        end -> new Recovery.EndedGoal(request(), ((JournalEntry.Over) end.entry()).outcome()));
  }

  /** Calls that may go on though nobody wants them. */
  List<Recovery.UnfinishedCall> unwanted() {
    return calls.values().stream()
        .filter(call -> over.isPresent() || call.calledOff.isPresent())
        .map(Call::unfinished)
        .toList();
  }

  /**
   * @param parts of it that have no end yet
   * @param endedParts those that have
   */
  Recovery.UnfinishedGoal unfinished(
      List<Recovery.UnfinishedGoal> parts, List<Recovery.EndedGoal> endedParts) {
    JournalEntry.Submitted first = (JournalEntry.Submitted) submitted.entry();
    Optional<JournalEntry.Became> state = became.map(dated -> (JournalEntry.Became) dated.entry());
    return new Recovery.UnfinishedGoal(
        first.goalId(),
        first.request(),
        submitted.at(),
        state.map(JournalEntry.Became::state).orElse(GoalState.SUBMITTED),
        state.map(JournalEntry.Became::reason).orElse(""),
        effort(),
        keeps
            .map(dated -> (JournalEntry.Keeps) dated.entry())
            .orElseGet(() -> JournalEntry.Keeps.nothing(first.goalId())),
        memory(),
        calls.values().stream()
            .filter(call -> call.calledOff.isEmpty())
            .map(Call::unfinished)
            .toList(),
        lastEnd.map(dated -> (JournalEntry.Ended) dated.entry()),
        parts,
        endedParts);
  }

  private Recovery.GoalMemory memory() {
    return new Recovery.GoalMemory(
        held.isPresent(),
        failures.values().stream().map(failed -> (JournalEntry.Failed) failed.entry()).toList(),
        looks.stream().map(look -> (JournalEntry.LookedInVain) look.entry()).toList(),
        settings.map(dated -> ((JournalEntry.Settings) dated.entry()).settings()).orElse(List.of()),
        asked.map(dated -> (JournalEntry.Asked) dated.entry()),
        notes.values().stream().map(noted -> (JournalEntry.Noted) noted.entry()).toList());
  }
}
