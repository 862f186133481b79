package org.maestro.agents;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.util.List;
import java.util.Optional;
import org.maestro.agents.centre.Interpreter;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.knowledge.KnowledgeCopy;
import org.maestro.agents.references.KeptReference;
import org.maestro.agents.references.Wanted;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.dialogue.Dialogues;
import org.maestro.sl.Content;

/**
 * The understanding of what people say as an agent of its own (ADE, 3; A15): it knows the home's
 * words, and does nothing itself. What is to be so it states as a goal to the agent that has goals,
 * and what is asked it asks of the knowledge agent; it refers to both through the registry.
 *
 * <pre>
 * (say "turn on the light" (:by Dave) (:in bedroom))      answered as the central agent does
 * </pre>
 */
public final class LanguageAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;

  private final transient KnowledgeCopy copy;
  private final transient Dialogues dialogues;
  private transient Optional<AID> hasGoals = Optional.empty();
  private transient Optional<Interpreter> interpreter = Optional.empty();

  /**
   * @param copy of what is known, to which words refer
   */
  public LanguageAgent(Birth birth, AgentTime time, KnowledgeCopy copy) {
    super(birth, time);
    this.copy = copy;
    this.dialogues = new Dialogues(copy::home, copy::snapshot, time.clock()::instant);
  }

  @Override
  protected void setup() {
    super.setup();
    KeptReference goals =
        references()
            .keep(
                List.of(Wanted.agent(AgentNames.GOALS), Wanted.agent(AgentNames.COORDINATOR)),
                its -> changed(its.agent()));
    KeptReference memory =
        references().keep(List.of(Wanted.agent(AgentNames.KNOWLEDGE)), its -> {});
    interpreter = Optional.of(new Interpreter(this, copy, dialogues, goals, memory));
  }

  /** Who waits for one that is gone, or cannot be reached, is told so. */
  private void changed(Optional<AID> now) {
    if (now.isEmpty()) {
      hasGoals.ifPresent(gone -> conversations().partnerEnded(gone.getLocalName(), getAMS()));
    }
    hasGoals = now;
  }

  @Override
  protected void received(ACLMessage message) {
    for (Content content : Words.parse(message.getContent())) {
      if (!content.operator().equals("say")) {
        refuse(
            message,
            ACLMessage.NOT_UNDERSTOOD,
            "The agent %s does not know the operator %s; it knows say."
                .formatted(getLocalName(), Replies.shortened(content.operator())));
      } else if (!copy.hasBegun()) {
        refuse(
            message,
            ACLMessage.REFUSE,
            "The agent %s has not been told yet what is known; say it again in a moment."
                .formatted(getLocalName()));
      } else {
        interpreter.ifPresent(its -> its.say(message, Words.of(content)));
      }
    }
  }
}
