package org.maestro.agents.stepping;

import jade.core.AID;
import jade.core.Agent;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.maestro.rats.time.Clock;

/**
 * The mail between the stepped agents of one platform: a message sent now is posted as an event of
 * the clock, a stated simulated time later. Any thread may call it.
 */
public final class SteppedMail {
  /** Simulated time that a message takes. */
  private static final Duration TRANSIT = Duration.ofMillis(1);

  private record Box(Agent agent, WorkTickets tickets) {}

  private final Clock clock;
  private final Map<String, Box> boxByName = new ConcurrentHashMap<>();

  public SteppedMail(Clock clock) {
    this.clock = clock;
  }

  public void open(Agent agent, WorkTickets tickets) {
    boxByName.put(agent.getName(), new Box(agent, tickets));
  }

  public void close(Agent agent) {
    boxByName.remove(agent.getName());
  }

  /** Takes the message on if its receiver is stepped too; otherwise JADE delivers it. */
  boolean take(ACLMessage message, AID receiver) {
    if (!boxByName.containsKey(receiver.getName())) {
      return false;
    }
    clock.schedule(TRANSIT, receiver.getLocalName(), () -> deliver(message, receiver.getName()));
    return true;
  }

  private void deliver(ACLMessage message, String receiver) {
    Box box = boxByName.get(receiver);
    if (box != null) {
      box.tickets().expect(message);
      box.agent().postMessage(message);
    }
  }
}
