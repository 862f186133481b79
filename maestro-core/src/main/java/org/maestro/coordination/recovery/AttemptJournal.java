package org.maestro.coordination.recovery;

import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;

/**
 * The journal as an attempt to bring a held goal about writes it: what it has for itself and what
 * it learns counts until the attempt is over. Where the goal stands, and its end, are told for the
 * goal as a whole.
 */
public final class AttemptJournal implements Journal {
  private final String goalId;
  private final Journal journal;

  /** There may be something written down from before a restart. */
  private boolean written = true;

  public AttemptJournal(String goalId, Journal journal) {
    this.goalId = goalId;
    this.journal = journal;
  }

  @Override
  public void write(JournalEntry entry) {
    if (entry instanceof JournalEntry.Keeps
        || entry instanceof JournalEntry.Failed
        || entry instanceof JournalEntry.LookedInVain) {
      written = true;
      journal.write(entry);
    }
  }

  @Override
  public void afterwards(Runnable action) {
    journal.afterwards(action);
  }

  /** What it wrote is of no use any more. */
  public void over() {
    if (written) {
      written = false;
      journal.write(new JournalEntry.AttemptOver(goalId));
    }
  }
}
