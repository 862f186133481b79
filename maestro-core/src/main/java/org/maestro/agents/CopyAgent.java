package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import java.util.List;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Replies;
import org.maestro.agents.knowledge.CopiedBeliefs;
import org.maestro.agents.knowledge.KnowledgeCopy;
import org.maestro.agents.references.Wanted;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;

/**
 * Keeps the copy of what is known for the parts that live in its process (ADE, 3; A15), by a
 * reference to the knowledge agent: when that is lost and there is another, it begins anew.
 */
public final class CopyAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;

  private final transient CopiedBeliefs beliefs;

  public CopyAgent(Birth birth, AgentTime time, KnowledgeCopy copy) {
    super(birth, time);
    this.beliefs = new CopiedBeliefs(this, copy);
  }

  @Override
  protected void setup() {
    super.setup();
    references()
        .keep(List.of(Wanted.agent(AgentNames.KNOWLEDGE)), memory -> beliefs.from(memory.agent()));
  }

  @Override
  protected void takeDown() {
    beliefs.end();
    super.takeDown();
  }

  @Override
  protected void received(ACLMessage message) {
    refuse(
        message,
        ACLMessage.REFUSE,
        "%s keeps a copy of what is known, and answers nobody, not even %s; ask the agent %s."
            .formatted(getLocalName(), Replies.sender(message), AgentNames.KNOWLEDGE));
  }
}
