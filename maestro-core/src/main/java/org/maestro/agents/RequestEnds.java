package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import org.maestro.deployment.DeploymentException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** How a request to the supervisor ends. Agent thread only. */
final class RequestEnds {
  private static final Logger LOG = LoggerFactory.getLogger(RequestEnds.class);

  private final MaestroAgent supervisor;

  RequestEnds(MaestroAgent supervisor) {
    this.supervisor = supervisor;
  }

  void failed(ACLMessage message, RuntimeException why) {
    if (!(why instanceof DeploymentException)) {
      LOG.warn("What {} asked for cannot be done", Replies.sender(message), why);
    }
    supervisor.refuse(message, ACLMessage.REFUSE, String.valueOf(why.getMessage()));
  }

  void done(ACLMessage message, String sentence) {
    supervisor.reply(
        message,
        ACLMessage.INFORM,
        Words.content("inform", Words.named("text", Words.text(sentence))));
  }

  /** Where the description that a request brings was read. */
  static String source(Words words) {
    return words.string("file").orElse("the description");
  }
}
