package org.maestro.agents.runtime;

import jade.core.Agent;
import java.time.Duration;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.maestro.agents.stepping.WorkTickets;
import org.maestro.rats.time.Clock;

/** Work handed to an agent by other threads, done on the agent's own, in order of arrival. */
final class Inbox {
  private record Work(Runnable action, Clock.Ticket ticket) {}

  private final transient Queue<Work> queue = new ConcurrentLinkedQueue<>();
  private final transient Agent agent;
  private final transient OwnThread thread;
  private final transient Clock clock;
  private final transient WorkTickets tickets;
  private volatile boolean ended;

  Inbox(Agent agent, OwnThread thread, Clock clock, WorkTickets tickets) {
    this.agent = agent;
    this.thread = thread;
    this.clock = clock;
    this.tickets = tickets;
  }

  /**
   * Any thread. On a stepped clock the work is an event of its own, so that nothing else is under
   * way with it.
   */
  void add(Runnable action) {
    if (clock.isStepped()) {
      clock.schedule(Duration.ZERO, agent.getLocalName(), () -> enqueue(action));
    } else {
      enqueue(action);
    }
  }

  private void enqueue(Runnable action) {
    queue.add(new Work(action, clock.hold("the inbox of " + agent.getLocalName())));
    if (ended) {
      end();
    } else {
      thread.wake();
    }
  }

  boolean hasWork() {
    return !queue.isEmpty();
  }

  /** Does one thing; returns whether there was one. Agent thread only. */
  boolean step() {
    Work work = queue.poll();
    if (work == null) {
      return false;
    }
    tickets.taken(work.ticket());
    thread.work(work.action());
    return true;
  }

  /** The agent ends: nobody will do what is left. */
  void end() {
    ended = true;
    for (Work work = queue.poll(); work != null; work = queue.poll()) {
      work.ticket().close();
    }
  }
}
