package org.maestro.agents.runtime;

import jade.core.behaviours.Behaviour;
import jade.core.behaviours.WrapperBehaviour;
import java.util.function.BooleanSupplier;

/**
 * Leads the conversation of a behaviour: it goes on for as long as it has something to do, and then
 * rests until there is a message of its conversation. JADE's protocols take many small actions for
 * one message, JADE wakes every behaviour for every message, and after each action an agent gives
 * its core away: with more threads ready than cores, each time for as long as all others take their
 * turn.
 */
public final class BatchingBehaviour extends WrapperBehaviour {
  private static final long serialVersionUID = 1L;

  /** The agent's other behaviours get their turn then. */
  private static final int MOST_AT_ONCE = 64;

  private final transient BooleanSupplier hasMail;

  /**
   * @param hasMail whether there is a message of the conversation; any thread may ask
   */
  public BatchingBehaviour(Behaviour behaviour, BooleanSupplier hasMail) {
    super(behaviour);
    this.hasMail = hasMail;
  }

  /** For each message that comes; what interrupts a behaviour restarts it another way. */
  @Override
  public void restart() {
    if (hasMail.getAsBoolean()) {
      super.restart();
    }
  }

  @Override
  public void action() {
    int actions = 0;
    do {
      super.action();
      actions++;
    } while (actions < MOST_AT_ONCE && !done() && getWrappedBehaviour().isRunnable());
  }
}
