package org.maestro.sl;

import java.time.DayOfWeek;
import java.time.LocalDate;
import java.time.LocalTime;
import java.util.Collections;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;

/** The time or the event to which a goal is bound. */
public sealed interface Occasion {

  /**
   * A time as clocks on the wall show it.
   *
   * @param date empty: the next day on which it is that time
   * @param days of the week on which it comes; none: on any
   * @param again whether it comes on each of them; else once, on the next
   */
  record At(Optional<LocalDate> date, LocalTime time, Set<DayOfWeek> days, boolean again)
      implements Occasion {
    public At {
      days = days.isEmpty() ? Set.of() : Collections.unmodifiableSet(EnumSet.copyOf(days));
    }

    /** Once, on any day of the week. */
    public static At once(Optional<LocalDate> date, LocalTime time) {
      return new At(date, time, Set.of(), false);
    }
  }

  /** So many seconds after it was stated. */
  record After(double seconds) implements Occasion {}

  /**
   * The condition becomes known to hold, for values of its free variables.
   *
   * @param again whether each time counts, and what is so already does not; else the first time
   *     does, which may be now
   */
  record Event(Formula condition, boolean again) implements Occasion {}
}
