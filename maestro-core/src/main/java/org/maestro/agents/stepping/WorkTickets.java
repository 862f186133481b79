package org.maestro.agents.stepping;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import org.maestro.rats.time.Clock;

/**
 * The tickets of one agent's work. A ticket is held from a message's delivery until the agent has
 * taken the message and has nothing more to do. What was delivered but not yet taken keeps its
 * ticket: arrival and waking up may race as they like.
 */
public final class WorkTickets {
  private final Clock clock;
  private final String holder;
  private final IdentityHashMap<ACLMessage, Clock.Ticket> delivered = new IdentityHashMap<>();
  private final List<Clock.Ticket> taken = new ArrayList<>();

  public WorkTickets(Clock clock, String holder) {
    this.clock = clock;
    this.holder = holder;
  }

  synchronized void expect(ACLMessage message) {
    delivered.put(message, clock.hold(holder + ", to whom a message was delivered"));
  }

  synchronized void taken(ACLMessage message) {
    Clock.Ticket ticket = delivered.remove(message);
    if (ticket != null) {
      taken.add(ticket);
    }
  }

  /** Work that came another way than by mail; its ticket is kept until the agent is idle. */
  public synchronized void taken(Clock.Ticket ticket) {
    taken.add(ticket);
  }

  /** Nothing that was taken is being worked on any more. */
  public synchronized void idle() {
    taken.forEach(Clock.Ticket::close);
    taken.clear();
  }

  /** The agent ends: whatever it had to do is not done any more. */
  public synchronized void end() {
    idle();
    delivered.values().forEach(Clock.Ticket::close);
    delivered.clear();
  }
}
