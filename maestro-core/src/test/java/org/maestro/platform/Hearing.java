package org.maestro.platform;

import jade.core.Agent;
import jade.core.behaviours.CyclicBehaviour;
import jade.lang.acl.ACLMessage;
import java.util.function.Consumer;

/** The hearing of an agent: each message that comes is told, on the agent's thread. */
public final class Hearing extends CyclicBehaviour {
  private static final long serialVersionUID = 1L;
  private final transient Consumer<ACLMessage> heard;

  public Hearing(Agent agent, Consumer<ACLMessage> heard) {
    super(agent);
    this.heard = heard;
  }

  @Override
  public void action() {
    ACLMessage message = myAgent.receive();
    if (message == null) {
      block();
    } else {
      heard.accept(message);
    }
  }
}
