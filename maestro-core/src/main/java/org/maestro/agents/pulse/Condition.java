package org.maestro.agents.pulse;

/** What is known of somebody who should give signs of life. */
public enum Condition {
  ALIVE,
  /** Silent for longer than usual: nothing is asked of it. */
  SUSPECTED,
  /** Given up for good, also if it speaks again. */
  LOST
}
