package org.maestro.platform.journal;

import java.time.Duration;
import java.util.function.Consumer;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.journal.JournalImage;
import org.maestro.rats.time.Clock;

/**
 * Remembers in memory what is written into a journal, so that a central agent that was ended can be
 * started again within the same process. Thread-safe as the journal is.
 */
public final class Chronicle implements Journal {
  private static final Duration ENDED_GOALS_ARE_KEPT = Duration.ofHours(1);
  private static final long MOST_BYTES_OF_ENDED_GOALS = 512 << 10;

  private final Journal journal;
  private final Clock clock;
  private final JournalImage image;
  private final Consumer<JournalEntry> listener;

  /**
   * @param past with which the process began
   * @param listener told of each entry, on the thread that writes it; it must not block
   */
  public Chronicle(Journal journal, Clock clock, Recovery past, Consumer<JournalEntry> listener) {
    this.journal = journal;
    this.clock = clock;
    this.listener = listener;
    this.image = JournalImage.of(past, clock.now());
  }

  @Override
  public void write(JournalEntry entry) {
    note(entry);
    journal.write(entry);
  }

  @Override
  public void accept(JournalEntry.Submitted goal, Runnable accepted, Consumer<String> refused) {
    journal.accept(
        goal,
        () -> {
          note(goal);
          accepted.run();
        },
        refused);
  }

  private void note(JournalEntry entry) {
    remember(entry);
    listener.accept(entry);
  }

  private synchronized void remember(JournalEntry entry) {
    image.add(new JournalImage.Dated(clock.now(), entry));
    if (entry instanceof JournalEntry.Over) {
      image.forgetEnded(clock.now().minus(ENDED_GOALS_ARE_KEPT), MOST_BYTES_OF_ENDED_GOALS);
    }
  }

  @Override
  public void afterwards(Runnable action) {
    journal.afterwards(action);
  }

  /** What another coordinator has to go on with. */
  public synchronized Recovery recovery() {
    return image.recovery();
  }
}
