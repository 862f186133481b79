package org.maestro.planning.pddl;

/** A PDDL text cannot be read; the message names file, line and column, and what was expected. */
public final class PddlException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final int line;
  private final int column;

  PddlException(String source, int line, int column, String problem) {
    super("%s:%d:%d: %s".formatted(source, line, column, problem));
    this.line = line;
    this.column = column;
  }

  /** Counted from 1. */
  public int line() {
    return line;
  }

  /** Counted from 1. */
  public int column() {
    return column;
  }
}
