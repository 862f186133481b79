package org.maestro.agents.runtime;

import jade.core.Agent;
import jade.lang.acl.ACLMessage;
import java.util.Collections;
import java.util.Set;
import org.maestro.agents.content.ProposalReader;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.rats.bounded.BoundedMap;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Answers messages that nobody expects with not-understood, once for each conversation, and never
 * what may itself be such an answer: two agents must not protest at each other for ever. Agent
 * thread only.
 */
final class NotUnderstoodReplier {
  private static final Logger LOG = LoggerFactory.getLogger(NotUnderstoodReplier.class);
  private static final int REMEMBERED = 256;

  private final Agent agent;
  private final Set<String> answered = Collections.newSetFromMap(BoundedMap.ofNewest(REMEMBERED));
  private int number;

  NotUnderstoodReplier(Agent agent) {
    this.agent = agent;
  }

  /**
   * @param sentence what is wrong, and what to do
   */
  void against(ACLMessage message, String sentence) {
    LOG.warn(
        "{} does not expect this {} from {}: {}",
        agent.getLocalName(),
        ProposalReader.performative(message),
        Replies.sender(message),
        sentence);
    if (mayBeAnswered(message)) {
      ACLMessage reply = message.createReply();
      reply.setPerformative(ACLMessage.NOT_UNDERSTOOD);
      reply.setLanguage(Words.LANGUAGE);
      reply.setOntology(Words.ONTOLOGY);
      reply.setEncoding(null);
      reply.setReplyWith(mark() + ++number);
      reply.setContent(
          Words.print(Words.content("inform", Words.named("reason", Words.text(sentence)))));
      agent.send(reply);
    }
  }

  /** Says so in the log only; what comes late is nobody's fault that asks. */
  void drop(ACLMessage message, String why) {
    LOG.info(
        "{} drops a {} from {}: {}",
        agent.getLocalName(),
        ProposalReader.performative(message),
        Replies.sender(message),
        why);
  }

  private boolean mayBeAnswered(ACLMessage message) {
    if (message.getSender() == null || message.getSender().getName() == null) {
      return false;
    }
    String inReplyTo = message.getInReplyTo();
    if (inReplyTo != null && inReplyTo.startsWith(mark())) {
      return false;
    }
    return switch (message.getPerformative()) {
      case ACLMessage.NOT_UNDERSTOOD, ACLMessage.FAILURE, ACLMessage.REFUSE -> false;
      default ->
          message.getConversationId() == null
              || answered.add(message.getSender().getName() + " " + message.getConversationId());
    };
  }

  private String mark() {
    return "protest-of-" + agent.getLocalName() + "-";
  }
}
