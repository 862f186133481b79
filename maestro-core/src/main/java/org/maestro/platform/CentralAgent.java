package org.maestro.platform;

import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.agents.CoordinatorAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.goals.Past;
import org.maestro.agents.lives.AgentLifeListener;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.platform.journal.Chronicle;
import org.maestro.rats.time.Clock;

/**
 * The central agent, which can be ended and started again; its goals go on. Any thread may call.
 */
final class CentralAgent implements AgentLifeListener {
  private final Function<Past, CoordinatorAgent> making;
  private final Chronicle chronicle;
  private volatile CoordinatorAgent coordinator;
  private volatile boolean isThere = true;

  /**
   * @param listener told of what is written into its journal
   * @param making makes one, with the past on which it goes on
   */
  CentralAgent(
      Past past,
      Clock clock,
      Consumer<JournalEntry> listener,
      Function<Past, CoordinatorAgent> making) {
    this.making = making;
    this.chronicle = new Chronicle(past.journal(), clock, past.recovery(), listener);
    this.coordinator = making.apply(new Past(chronicle, past.recovery(), past.stories()));
  }

  /** The one there is now, or the last one. */
  CoordinatorAgent now() {
    return coordinator;
  }

  @Override
  public void agentDied(String agent) {
    if (agent.equals(AgentNames.COORDINATOR)) {
      isThere = false;
    }
  }

  @Override
  public void agentDoubted(String agent, String reason) {
    coordinator.agentDoubted(agent, reason);
  }

  @Override
  public void agentTrusted(String agent) {
    coordinator.agentTrusted(agent);
  }

  @Override
  public void agentMoves(String agent) {
    coordinator.agentMoves(agent);
  }

  @Override
  public void agentEnded(String agent) {
    coordinator.agentEnded(agent);
  }

  @Override
  public void agentStaysAway(String member, String reason) {
    coordinator.agentStaysAway(member, reason);
  }

  /**
   * Makes another in the place of one that was ended.
   *
   * @param starting has it begin
   * @return false when it is there
   */
  synchronized boolean revive(Consumer<CoordinatorAgent> starting) {
    if (isThere) {
      return false;
    }
    CoordinatorAgent revived =
        making.apply(new Past(chronicle, chronicle.recovery(), coordinator.stories(), true));
    coordinator = revived;
    isThere = true;
    starting.accept(revived);
    return true;
  }
}
