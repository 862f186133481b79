package org.maestro.coordination.scripts;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Recovery;
import org.maestro.sl.Term;

/**
 * How far a script has come, written down as it goes on and read when it is taken up: parts that
 * are over, values that were found, and ends of the goals that were pursued for it.
 */
final class Notes {
  private final String goalId;
  private final Journal journal;
  private final TreeMap<String, JournalEntry.Noted> notes = new TreeMap<>();
  private final TreeMap<String, GoalOutcome> ends = new TreeMap<>();
  private final Set<String> underway = new TreeSet<>();

  Notes(String goalId, Journal journal) {
    this.goalId = goalId;
    this.journal = journal;
  }

  /**
   * What was noted before a restart.
   *
   * @param unfinished goals for parts of the script that had no end yet
   */
  void takeUp(
      List<JournalEntry.Noted> former,
      List<GoalOutcome> ended,
      List<Recovery.UnfinishedGoal> unfinished) {
    former.forEach(note -> notes.put(note.path(), note));
    ended.forEach(outcome -> ends.put(path(outcome.id()), outcome));
    unfinished.forEach(goal -> underway.add(path(goal.id())));
  }

  private String path(String partId) {
    return partId.substring(goalId.length() + 1);
  }

  String partId(String path) {
    return GoalId.part(goalId, path);
  }

  /** How the part has ended; empty when it has not, as far as is known. */
  Optional<Result> result(String path) {
    Optional<JournalEntry.Noted> note =
        Optional.ofNullable(notes.get(path)).filter(JournalEntry.Noted::over);
    return note.map(Notes::result).or(() -> Optional.ofNullable(ends.get(path)).map(Notes::result));
  }

  private static Result result(JournalEntry.Noted note) {
    if (note.problem().isPresent()) {
      return new Result.Failed(note.problem().get());
    }
    return note.value().<Result>map(Result.Returned::new).orElseGet(Result.Done::new);
  }

  static Result result(GoalOutcome outcome) {
    return outcome.state() == GoalState.ACHIEVED
        ? new Result.Done()
        : new Result.Failed(String.join(" ", outcome.reasons()));
  }

  /** What a variable, or the way that is taken, was noted to be. */
  Optional<Term> value(String path) {
    return Optional.ofNullable(notes.get(path))
        .filter(note -> !note.over())
        .flatMap(JournalEntry.Noted::value);
  }

  /** When a wait that was begun is over, on the clock. */
  Optional<Duration> until(String path) {
    return Optional.ofNullable(notes.get(path)).flatMap(JournalEntry.Noted::until);
  }

  /** Whether anything has become of the part or below it. */
  boolean isBegun(String path) {
    String below = path + ".";
    return notes.keySet().stream().anyMatch(noted -> isAtOrBelow(noted, path, below))
        || ends.keySet().stream().anyMatch(ended -> isAtOrBelow(ended, path, below))
        || underway.stream().anyMatch(at -> isAtOrBelow(at, path, below));
  }

  private static boolean isAtOrBelow(String one, String path, String below) {
    return one.equals(path) || one.startsWith(below);
  }

  void over(String path, Result result) {
    write(
        new JournalEntry.Noted(
            goalId, path, true, result.given(), result.problem(), Optional.empty()));
  }

  void value(String path, Term value) {
    write(
        new JournalEntry.Noted(
            goalId, path, false, Optional.of(value), Optional.empty(), Optional.empty()));
  }

  void until(String path, Duration end) {
    write(
        new JournalEntry.Noted(
            goalId, path, false, Optional.empty(), Optional.empty(), Optional.of(end)));
  }

  private void write(JournalEntry.Noted note) {
    if (note.equals(notes.get(note.path()))) {
      return;
    }
    journal.write(note);
    String below = note.path() + ".";
    notes.keySet().removeIf(path -> path.startsWith(below));
    ends.keySet().removeIf(path -> path.startsWith(below));
    underway.removeIf(path -> path.startsWith(below));
    notes.put(note.path(), note);
  }
}
