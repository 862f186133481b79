package org.maestro.agents.stepping;

import jade.core.behaviours.Behaviour;
import jade.core.behaviours.CyclicBehaviour;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/**
 * Scheduled in turn with an agent's other behaviours, it gives the agent's tickets back when none
 * of the others can run. Whatever the agent has done, it has to be restarted after it: JADE wakes
 * it with each message, too, and can lose such a waking. Agent thread only, but for {@code
 * restart}.
 */
public final class IdleDetector extends CyclicBehaviour {
  private static final long serialVersionUID = 1L;

  private final transient WorkTickets tickets;
  private final transient Collection<Behaviour> others = new ArrayList<>();
  private final transient Runnable firstTime;
  private boolean wasIdle;

  /**
   * @param firstTime told once, when the agent is idle for the first time
   */
  public IdleDetector(WorkTickets tickets, Runnable firstTime) {
    this.tickets = tickets;
    this.firstTime = firstTime;
  }

  public synchronized void added(Behaviour behaviour) {
    others.add(behaviour);
  }

  public synchronized void removed(Behaviour behaviour) {
    others.remove(behaviour);
  }

  @Override
  public void action() {
    if (othersCanRun()) {
      return;
    }
    tickets.idle();
    if (!wasIdle) {
      wasIdle = true;
      firstTime.run();
    }
    block();
  }

  /** The agent's behaviours that are not done, without this one. */
  public synchronized int behaviourCount() {
    others.removeIf(Behaviour::done);
    return others.size();
  }

  private synchronized boolean othersCanRun() {
    others.removeIf(Behaviour::done);
    return List.copyOf(others).stream().anyMatch(Behaviour::isRunnable);
  }
}
