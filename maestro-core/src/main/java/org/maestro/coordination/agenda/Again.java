package org.maestro.coordination.agenda;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.maestro.sl.Formula;

/** Begins its goal at a time of each day, or of some days of the week, until it is cancelled. */
final class Again implements Vigil {
  private static final int MOST_TOLD = 5;

  private final Entry entry;
  private final Due due;
  private final Formula goal;

  Again(Entry entry, Due due, Formula goal) {
    this.entry = entry;
    this.due = due;
    this.goal = goal;
  }

  @Override
  public void start() {
    awaitNext(entry.statedAt());
  }

  private void awaitNext(Duration after) {
    Duration next = due.after(after).orElseThrow();
    due.note(next);
    await(next);
  }

  private void await(Duration next) {
    entry.awaits(entry.inWords(next));
    entry.at(next, () -> begin(next));
  }

  /** What comes next is written down first, so that a restart does not begin it twice. */
  private void begin(Duration moment) {
    awaitNext(moment);
    entry.begin(goal, "because it was to be begun at " + entry.inWords(moment), why -> {});
  }

  @Override
  public void takeUp() {
    Optional<Duration> noted = due.noted();
    if (noted.isEmpty()) {
      start();
      return;
    }
    entry.unborn().ifPresent(id -> entry.missed("what was to be begun as " + id));
    if (due.isMissed(noted.get())) {
      Duration back = entry.back().orElseThrow();
      entry.missed(told(due.between(noted.get(), back).stream().map(entry::inWords).toList()));
      awaitNext(back);
    } else {
      await(noted.get());
    }
  }

  private static String told(List<String> moments) {
    int more = moments.size() - MOST_TOLD;
    return moments.stream().limit(MOST_TOLD).collect(Collectors.joining(", "))
        + (more > 0 ? " and " + more + " more" : "");
  }
}
