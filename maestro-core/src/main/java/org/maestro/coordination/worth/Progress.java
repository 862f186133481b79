package org.maestro.coordination.worth;

import java.time.Duration;
import java.util.OptionalDouble;

/** The progress of a goal, as far as its worth depends on it. The coordinator's thread only. */
public interface Progress {

  /** The cost of what is left of its plan; empty while it has none. */
  OptionalDouble remainingCost();

  /** The time of the clock since when it is pursued; of a goal that is held and so, now. */
  Duration pursuedSince();
}
