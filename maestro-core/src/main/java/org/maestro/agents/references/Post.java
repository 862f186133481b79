package org.maestro.agents.references;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import org.maestro.rats.time.Clock;

/** The surroundings of an agent that refers to others, or is referred to. */
public interface Post {
  AID self();

  /** Who is asked for references. */
  AID registry();

  void send(ACLMessage message);

  Clock clock();

  /** Has the agent do this on its own thread, soon. */
  void tell(Runnable action);
}
