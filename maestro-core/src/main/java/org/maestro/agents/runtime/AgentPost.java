package org.maestro.agents.runtime;

import jade.core.AID;
import jade.core.Agent;
import jade.lang.acl.ACLMessage;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.references.Post;
import org.maestro.rats.time.Clock;

/** An agent as one that refers to others: the supervisor is its registry. */
record AgentPost(Agent agent, OwnThread thread, AgentTime time) implements Post {
  @Override
  public AID self() {
    return agent.getAID();
  }

  @Override
  public AID registry() {
    return agent.getAID(AgentNames.SUPERVISOR);
  }

  @Override
  public void send(ACLMessage message) {
    agent.send(message);
  }

  @Override
  public Clock clock() {
    return time.clock();
  }

  @Override
  public void tell(Runnable action) {
    thread.tell(action);
  }
}
