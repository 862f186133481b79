package org.maestro.coordination.agenda;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.sl.Occasion;
import org.maestro.sl.Term;

/** The times at which an occasion comes that is no event, on the coordinator's clock. */
final class Due {
  private static final String NOTED = "2";

  private final Occasion occasion;
  private final Entry entry;

  Due(Occasion occasion, Entry entry) {
    this.occasion = occasion;
    this.entry = entry;
  }

  /** The first one after that; empty when there is none. */
  Optional<Duration> after(Duration moment) {
    if (occasion instanceof Occasion.After after) {
      return Optional.of(moment.plusMillis(Math.round(after.seconds() * 1000)));
    }
    return new Timetable((Occasion.At) occasion, entry.zone())
        .next(entry.instant(moment))
        .map(entry::onClock);
  }

  /** All from the first one on, before the second. */
  List<Duration> between(Duration first, Duration before) {
    List<Duration> moments = new ArrayList<>();
    for (Optional<Duration> next = Optional.of(first);
        next.isPresent() && next.get().compareTo(before) < 0;
        next = after(next.get())) {
      moments.add(next.get());
    }
    return moments;
  }

  /** It is awaited, also after a restart. */
  void note(Duration moment) {
    Term shown = new Term.Text(entry.instant(moment).toString());
    entry.note(NOTED, Optional.of(shown), Optional.of(moment));
  }

  /**
   * The one that was awaited before a restart. What clocks on the wall showed is exact; times on
   * the coordinator's clock, which another has now, are not.
   */
  Optional<Duration> noted() {
    Optional<JournalEntry.Noted> note = entry.note(NOTED);
    return occasion instanceof Occasion.After
        ? note.flatMap(JournalEntry.Noted::until)
        : note.flatMap(JournalEntry.Noted::value)
            .map(shown -> entry.onClock(Instant.parse(((Term.Text) shown).value())));
  }

  /** Whether it has come while no platform ran. */
  boolean isMissed(Duration moment) {
    return entry.back().filter(back -> moment.compareTo(back) < 0).isPresent();
  }
}
