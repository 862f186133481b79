package org.maestro.planning.cases;

/** PDDL has no words for a part of a task; the message says for which. */
public final class NotCarriedException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  NotCarriedException(String sentence) {
    super(sentence);
  }
}
