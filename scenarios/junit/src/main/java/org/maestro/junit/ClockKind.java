package org.maestro.junit;

/** How time passes on a stage. */
public enum ClockKind {
  /**
   * From event to event, as fast as the machine can: the same seed gives the same run. Everything
   * in this process, no broker.
   */
  STEPPED,
  /** Wall time times speed, over the real bus. */
  PACED
}
