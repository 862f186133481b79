package org.maestro.agents.lives;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;

/**
 * The one source of events in the lives of a platform's agents. Who listens is told each of them in
 * the order in which listeners were added, on the thread of whoever tells; when the platform itself
 * ends, nothing is told any more: what only ends with it has not ended for good. Any thread may
 * call.
 */
public final class AgentLives {
  private final List<AgentLifeListener> listeners = new CopyOnWriteArrayList<>();
  private volatile boolean over;

  /** Is told everything from now on. */
  public void listen(AgentLifeListener listener) {
    listeners.add(listener);
  }

  /** Is told nothing any more. */
  public void leave(AgentLifeListener listener) {
    listeners.remove(listener);
  }

  /**
   * Tells all listeners.
   *
   * @param event the listener's method that stands for it
   */
  public void tell(Consumer<AgentLifeListener> event) {
    if (!over) {
      listeners.forEach(event);
    }
  }

  /** The platform ends. */
  public void end() {
    over = true;
  }

  /** Whether the platform ends, and nothing is to begin any more. */
  public boolean areOver() {
    return over;
  }
}
