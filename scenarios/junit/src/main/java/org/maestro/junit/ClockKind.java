package org.maestro.junit;

/** The clock of a stage: how time passes there. */
public enum ClockKind {
  /**
   * From event to event, as fast as the machine can: the same seed gives the same run. Everything
   * in this process, no broker.
   */
  STEPPED,
  /** Wall time times speed, over the real bus. */
  PACED
}
