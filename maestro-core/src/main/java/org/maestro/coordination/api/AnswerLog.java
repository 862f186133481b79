package org.maestro.coordination.api;

/** A place where answers to questions of scripts are kept. Any thread may use it. */
public interface AnswerLog {

  /**
   * Keeps the answer.
   *
   * @param then run once it is kept, or will not be, on any thread; it hands over at once
   */
  void keep(GivenAnswer answer, Runnable then);
}
