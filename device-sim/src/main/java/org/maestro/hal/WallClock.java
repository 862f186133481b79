package org.maestro.hal;

/** A clock that shows the time of day. */
public interface WallClock {

  /** Whole minutes since midnight. */
  int minuteOfDay();
}
