package org.maestro.coordination.api;

import java.util.function.Consumer;

/**
 * A write-ahead log of the life of goals, so that another coordinator can go on with them after
 * this one's death. Called on the coordinator's thread; nothing blocks.
 *
 * <p>The order of things is what makes a step happen once: a call is written down before it is
 * sent, and is sent again, in the same words, by who finds it begun and not ended; the member then
 * answers what it has answered before.
 */
public interface Journal {

  /** Writes, in the order of these calls, some time before what is afterwards. */
  void write(JournalEntry entry);

  /**
   * Runs the action on the coordinator's thread once everything written so far would survive the
   * end of the process and of the machine. Actions run in the order of these calls.
   */
  void afterwards(Runnable action);

  /**
   * Writes a goal's first entry, unless it cannot be written now. Exactly one of both runs, on the
   * coordinator's thread.
   *
   * @param accepted once the goal would survive the end of the process and of the machine
   * @param refused told why it is not written, one sentence; it will not be written later
   */
  default void accept(JournalEntry.Submitted goal, Runnable accepted, Consumer<String> refused) {
    write(goal);
    afterwards(accepted);
  }

  /** Keeps nothing: goals end with their coordinator. */
  static Journal none() {
    return new Journal() {
      @Override
      public void write(JournalEntry entry) {
        // Nobody will read it.
      }

      @Override
      public void afterwards(Runnable action) {
        action.run();
      }
    };
  }
}
