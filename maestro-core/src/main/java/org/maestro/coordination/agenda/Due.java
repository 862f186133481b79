package org.maestro.coordination.agenda;

import java.time.Duration;
import java.util.Optional;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.sl.Occasion;

/** When an occasion that is a time comes, on the coordinator's clock. */
interface Due {

  /** The first time after that; empty when there is none. */
  Optional<Duration> after(Duration moment);

  static Due of(Occasion occasion, Entry entry) {
    if (occasion instanceof Occasion.After after) {
      Duration wait = Duration.ofMillis(Math.round(after.seconds() * 1000));
      return moment -> Optional.of(moment.plus(wait));
    }
    Timetable times = new Timetable((Occasion.At) occasion, entry.zone());
    return moment -> times.next(entry.instant(moment)).map(entry::onClock);
  }

  /** The time that was noted before a restart. */
  static Optional<Duration> noted(Entry entry, String path) {
    return entry.note(path).flatMap(JournalEntry.Noted::until);
  }

  /** Whether it has come while no platform ran. */
  static boolean isMissed(Entry entry, Duration moment) {
    return entry.back().filter(back -> moment.compareTo(back) < 0).isPresent();
  }
}
