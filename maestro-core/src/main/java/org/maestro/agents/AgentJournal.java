package org.maestro.agents;

import org.maestro.coordination.Journal;
import org.maestro.coordination.JournalEntry;
import org.maestro.rats.time.Clock;

/** A journal whose actions run on the agent's thread: what is written down elsewhere comes back. */
final class AgentJournal implements Journal {
  private final MaestroAgent agent;
  private final Clock clock;
  private final Journal elsewhere;

  AgentJournal(MaestroAgent agent, Clock clock, Journal elsewhere) {
    this.agent = agent;
    this.clock = clock;
    this.elsewhere = elsewhere;
  }

  @Override
  public void write(JournalEntry entry) {
    elsewhere.write(entry);
  }

  @Override
  public void afterwards(Runnable action) {
    boolean[] within = {true};
    Thread caller = Thread.currentThread();
    Clock.Ticket ticket = clock.hold("the journal");
    elsewhere.afterwards(
        () -> {
          if (within[0] && Thread.currentThread() == caller) {
            action.run();
          } else {
            agent.tell(action);
          }
          ticket.close();
        });
    within[0] = false;
  }
}
