package org.maestro.launch;

import java.util.Optional;

/** Where a person writes, and reads what she is told. Any thread may print, one reads. */
interface Keyboard extends AutoCloseable {

  /** Waits for the next line; empty when no more are to come. */
  Optional<String> line();

  /** Shows a line, without breaking the one that is being written. */
  void print(String line);

  /** Whether lines come only as fast as they are written; else each waits for its answer. */
  boolean isWrittenByHand();

  @Override
  void close();
}
