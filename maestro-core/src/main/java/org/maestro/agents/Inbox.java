package org.maestro.agents;

import jade.core.behaviours.CyclicBehaviour;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.maestro.rats.time.Clock;

/** Work handed to an agent by other threads, done on the agent's own, in order of arrival. */
final class Inbox extends CyclicBehaviour {
  private static final long serialVersionUID = 1L;

  private record Work(Runnable action, Clock.Ticket ticket) {}

  private final transient Queue<Work> queue = new ConcurrentLinkedQueue<>();
  private final transient MaestroAgent agent;
  private final transient Clock clock;

  Inbox(MaestroAgent agent, Clock clock) {
    super(agent);
    this.agent = agent;
    this.clock = clock;
  }

  /** Any thread. */
  void add(Runnable action) {
    queue.add(new Work(action, clock.hold("the inbox of an agent")));
    restart();
  }

  @Override
  public void action() {
    Work work = queue.poll();
    if (work == null) {
      block();
      if (!queue.isEmpty()) {
        restart();
      }
      return;
    }
    try {
      agent.work(work.action());
    } finally {
      work.ticket().close();
    }
  }
}
