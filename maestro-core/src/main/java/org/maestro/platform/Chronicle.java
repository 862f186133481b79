package org.maestro.platform;

import java.time.Duration;
import org.maestro.coordination.Journal;
import org.maestro.coordination.JournalEntry;
import org.maestro.coordination.JournalImage;
import org.maestro.coordination.Recovery;
import org.maestro.rats.time.Clock;

/**
 * Remembers in memory what is written into a journal, so that a central agent that was ended can be
 * started again within the same process. Thread-safe as the journal is.
 */
final class Chronicle implements Journal {
  private final Journal journal;
  private final Clock clock;
  private final JournalImage image;

  /**
   * @param past with which the process began
   */
  Chronicle(Journal journal, Clock clock, Recovery past) {
    this.journal = journal;
    this.clock = clock;
    this.image = JournalImage.of(past, clock.now());
  }

  @Override
  public void write(JournalEntry entry) {
    note(entry);
    journal.write(entry);
  }

  private synchronized void note(JournalEntry entry) {
    image.add(new JournalImage.Dated(clock.now(), entry));
    image.forgetEnded(clock.now().minus(Duration.ofHours(1)), 1_000);
  }

  @Override
  public void afterwards(Runnable action) {
    journal.afterwards(action);
  }

  /** What another coordinator has to go on with. */
  synchronized Recovery recovery() {
    return image.recovery();
  }
}
