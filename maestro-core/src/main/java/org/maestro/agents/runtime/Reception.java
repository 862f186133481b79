package org.maestro.agents.runtime;

import jade.core.Agent;
import jade.core.behaviours.CyclicBehaviour;
import java.util.List;
import java.util.function.BooleanSupplier;

/**
 * Does what an agent has to do of itself, one thing after the other, until nothing is left. It is
 * one behaviour, as JADE wakes every behaviour for every message and gives the core away after each
 * action.
 */
final class Reception extends CyclicBehaviour {
  private static final long serialVersionUID = 1L;

  /** The agent's other behaviours get their turn then. */
  private static final int MOST_AT_ONCE = 64;

  private final transient List<BooleanSupplier> sources;
  private final transient BooleanSupplier hasWork;
  private final transient Runnable idle;
  private boolean leaving;

  /**
   * @param sources each does one thing and returns whether there was one; messages among them
   * @param hasWork whether work came that no message told of
   * @param idle done when nothing is left
   */
  Reception(Agent agent, List<BooleanSupplier> sources, BooleanSupplier hasWork, Runnable idle) {
    super(agent);
    this.sources = List.copyOf(sources);
    this.hasWork = hasWork;
    this.idle = idle;
  }

  /**
   * JADE tells of both by one object that it fills anew: a message that comes while an agent begins
   * to rest could otherwise be told as that rest, and nobody would wake the agent for it.
   */
  @Override
  protected synchronized void handleBlockEvent() {
    super.handleBlockEvent();
  }

  @Override
  public synchronized void handleRestartEvent() {
    super.handleRestartEvent();
  }

  /** Nothing more is begun until JADE has had the chance to move the agent. Agent thread only. */
  void leave() {
    leaving = true;
  }

  @Override
  public void action() {
    leaving = false;
    int done = 0;
    boolean any = true;
    while (any && done < MOST_AT_ONCE) {
      any = false;
      for (BooleanSupplier source : sources) {
        if (!leaving && source.getAsBoolean()) {
          any = true;
          done++;
        }
      }
    }
    if (!any && !leaving) {
      idle.run();
      block();
      if (hasWork.getAsBoolean()) {
        restart();
      }
    }
  }
}
