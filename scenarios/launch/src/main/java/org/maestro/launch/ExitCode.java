package org.maestro.launch;

/** The exit status that the shell is told. */
final class ExitCode {
  static final int DONE = 0;

  /** A goal was not reached, or a check found faults. */
  static final int NOT_REACHED = 1;

  static final int BAD_INPUT = 2;

  /** Something outside failed: a port, a broker, a display, the disk. */
  static final int OUTSIDE = 3;

  /**
   * A goal was reached as far as those say who did it; nobody could look, or look again. It is no
   * plain success: a script that does not mind takes it as one.
   */
  static final int NOT_SEEN = 4;

  private ExitCode() {}
}
