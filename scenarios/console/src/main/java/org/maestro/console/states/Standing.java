package org.maestro.console.states;

/** The standing of a part of a platform, as far as is known. */
enum Standing {
  WELL,
  /** It is not there, and need not be. */
  OFF,
  /** Perhaps it is not there any more. */
  DOUBTFUL,
  /** What it is reached by is not well. */
  UNREACHABLE,
  /** It is there, and of no use. */
  FAILING,
  LOST
}
