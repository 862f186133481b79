package org.maestro.coordination.agenda;

import java.time.Duration;
import java.util.Optional;
import org.maestro.coordination.api.GoalState;
import org.maestro.sl.Formula;

/** Begins its goal at one moment, and ends with it. */
final class Once implements Vigil {
  private final Entry entry;
  private final Due due;
  private final Formula goal;

  Once(Entry entry, Due due, Formula goal) {
    this.entry = entry;
    this.due = due;
    this.goal = goal;
  }

  @Override
  public void start() {
    Optional<Duration> moment = due.after(entry.statedAt());
    if (moment.isEmpty()) {
      entry.end(GoalState.FAILED, "That time was over when it was stated.", "nobody");
    } else {
      due.note(moment.get());
      await(moment.get());
    }
  }

  private void await(Duration moment) {
    entry.awaits(entry.inWords(moment));
    entry.at(moment, () -> begin(moment));
  }

  private void begin(Duration moment) {
    String id =
        entry.begin(
            goal,
            "because it was to be begun at " + entry.inWords(moment),
            why -> entry.end(GoalState.FAILED, why, "nobody"));
    entry.follow(id, "");
  }

  @Override
  public void takeUp() {
    Optional<Duration> moment = due.noted().or(() -> due.after(entry.statedAt()));
    Optional<String> begun = entry.begunBefore();
    if (begun.isPresent() && entry.unborn().isEmpty()) {
      entry.followAgain(begun.get(), "");
    } else if (moment.isEmpty()) {
      start();
    } else if (begun.isPresent() || due.isMissed(moment.get())) {
      String when = entry.inWords(moment.get());
      entry.missed(when);
      entry.end(
          GoalState.FAILED,
          "It was to be begun at %s, when no platform ran; state it again if it is still wanted."
              .formatted(when),
          "nobody");
    } else {
      await(moment.get());
    }
  }
}
