package org.maestro.agents.goals;

import java.util.function.Consumer;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.rats.time.Clock;

/** A journal whose actions run on the agent's thread: what is written down elsewhere comes back. */
public final class AgentJournal implements Journal {
  private final MaestroAgent agent;
  private final Clock clock;
  private final Journal elsewhere;

  public AgentJournal(MaestroAgent agent, Clock clock, Journal elsewhere) {
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
    Return back = new Return();
    elsewhere.afterwards(() -> back.run(action));
    back.callIsOver();
  }

  @Override
  public void accept(JournalEntry.Submitted goal, Runnable accepted, Consumer<String> refused) {
    Return back = new Return();
    elsewhere.accept(
        goal, () -> back.run(accepted), reason -> back.run(() -> refused.accept(reason)));
    back.callIsOver();
  }

  /** The way back to the agent's thread, once. Time waits for it on a stepped clock. */
  private final class Return {
    private final Thread caller = Thread.currentThread();
    private final Clock.Ticket ticket = clock.hold("the journal");
    private boolean calling = true;

    private void run(Runnable action) {
      if (Thread.currentThread() == caller && calling) {
        action.run();
      } else {
        agent.tell(action);
      }
      ticket.close();
    }

    private void callIsOver() {
      calling = false;
    }
  }
}
