package org.maestro.platform.journal;

/** A line of a journal that cannot be read. The message says what is wrong with it. */
final class JournalDamage extends Exception {
  private static final long serialVersionUID = 1L;
  private final boolean incomplete;

  /**
   * @param incomplete it looks like the beginning of a line, as of a write that was cut short
   */
  JournalDamage(String message, boolean incomplete) {
    super(message);
    this.incomplete = incomplete;
  }

  boolean isIncomplete() {
    return incomplete;
  }
}
