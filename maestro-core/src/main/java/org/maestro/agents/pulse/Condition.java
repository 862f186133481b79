package org.maestro.agents.pulse;

/** The condition of somebody who should give signs of life, as far as it is known. */
public enum Condition {
  ALIVE,
  /** Silent for longer than usual: nothing is asked of it. */
  SUSPECTED,
  /** Given up for good, also if it speaks again. */
  LOST
}
