package org.maestro.coordination.agenda;

import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneId;
import java.time.ZonedDateTime;
import java.util.Optional;
import org.maestro.sl.Occasion;

/**
 * The moments at which clocks on the walls of one time zone show a time. On each day there is one:
 * a time that is left out when clocks are put forward comes as much later, and one that comes twice
 * counts the first time. Immutable.
 */
final class Timetable {
  /** The furthest that the next day of the week is, and a day that a zone may leave out. */
  private static final int DAYS = 9;

  private final Occasion.At at;
  private final ZoneId zone;

  Timetable(Occasion.At at, ZoneId zone) {
    this.at = at;
    this.zone = zone;
  }

  /** The first moment after that one; empty when there is none. */
  Optional<Instant> next(Instant after) {
    if (at.date().isPresent()) {
      return Optional.of(on(at.date().get())).filter(moment -> moment.isAfter(after));
    }
    LocalDate first = after.atZone(zone).toLocalDate().minusDays(1);
    return first
        .datesUntil(first.plusDays(DAYS))
        .filter(date -> at.days().isEmpty() || at.days().contains(date.getDayOfWeek()))
        .map(this::on)
        .filter(moment -> moment.isAfter(after))
        .findFirst();
  }

  private Instant on(LocalDate date) {
    return ZonedDateTime.of(date, at.time(), zone).toInstant();
  }
}
