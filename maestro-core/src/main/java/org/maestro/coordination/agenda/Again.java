package org.maestro.coordination.agenda;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.maestro.sl.Formula;
import org.maestro.sl.Occasion;

/** Begins its goal at a time of each day, or of some days of the week, until it is cancelled. */
final class Again implements Vigil {
  private static final String NEXT = "2";
  private static final int MOST_TOLD = 5;

  private final Entry entry;
  private final Occasion.At at;
  private final Formula goal;

  Again(Entry entry, Occasion.At at, Formula goal) {
    this.entry = entry;
    this.at = at;
    this.goal = goal;
  }

  @Override
  public void start() {
    awaitNext(entry.statedAt());
  }

  private Timetable times() {
    return new Timetable(at, entry.zone());
  }

  private void awaitNext(Duration after) {
    Duration next = entry.onClock(times().next(entry.instant(after)).orElseThrow());
    entry.noteTime(NEXT, next);
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
    Optional<Duration> noted = Due.noted(entry, NEXT);
    if (noted.isEmpty()) {
      start();
      return;
    }
    entry.unborn().ifPresent(id -> entry.missed("what was to be begun as " + id));
    if (Due.isMissed(entry, noted.get())) {
      Duration back = entry.back().orElseThrow();
      entry.missed(
          told(
              times().between(entry.instant(noted.get()), entry.instant(back)).stream()
                  .map(entry::onClock)
                  .map(entry::inWords)
                  .toList()));
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
