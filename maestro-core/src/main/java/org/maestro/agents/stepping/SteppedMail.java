package org.maestro.agents.stepping;

import jade.core.AID;
import jade.core.Agent;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.Map;
import java.util.Set;
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
  private final Set<String> closed = ConcurrentHashMap.newKeySet();

  public SteppedMail(Clock clock) {
    this.clock = clock;
  }

  public void open(Agent agent, WorkTickets tickets) {
    closed.remove(agent.getName());
    boxByName.put(agent.getName(), new Box(agent, tickets));
  }

  public void close(Agent agent) {
    closed.add(agent.getName());
    boxByName.remove(agent.getName());
  }

  /**
   * Takes the message on if its receiver is stepped too, or was while it lived; otherwise JADE
   * delivers it.
   */
  boolean take(ACLMessage message, AID receiver) {
    String name = receiver.getName();
    if (!boxByName.containsKey(name) && !closed.contains(name)) {
      return false;
    }
    clock.schedule(TRANSIT, receiver.getLocalName(), () -> deliver(message, name));
    return true;
  }

  private void deliver(ACLMessage message, String receiver) {
    Box box = boxByName.get(receiver);
    if (box != null) {
      post(message, box);
    } else {
      giveBack(message, receiver);
    }
  }

  /** As JADE does by its agent management system when there is no such agent. */
  private void giveBack(ACLMessage message, String receiver) {
    Box sender = boxByName.get(message.getSender().getName());
    if (sender != null) {
      ACLMessage failure = message.createReply();
      failure.setPerformative(ACLMessage.FAILURE);
      failure.setSender(sender.agent().getAMS());
      failure.setContent("((MTS-error " + receiver + " \"There is no such agent.\"))");
      post(failure, sender);
    }
  }

  private static void post(ACLMessage message, Box box) {
    box.tickets().expect(message);
    box.agent().postMessage(message);
  }
}
