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
   * @param every the days of the week on which it comes again; none: it comes once
   */
  record At(Optional<LocalDate> date, LocalTime time, Set<DayOfWeek> every) implements Occasion {
    public At {
      every = every.isEmpty() ? Set.of() : Collections.unmodifiableSet(EnumSet.copyOf(every));
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
