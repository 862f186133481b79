package org.maestro.agents.supervision;

import jade.lang.acl.ACLMessage;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.deployment.DeploymentException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The end of a request to the supervisor: done, or failed. Agent thread only. */
public final class RequestEnds {
  private static final Logger LOG = LoggerFactory.getLogger(RequestEnds.class);

  private final MaestroAgent supervisor;

  public RequestEnds(MaestroAgent supervisor) {
    this.supervisor = supervisor;
  }

  public void failed(ACLMessage message, RuntimeException why) {
    if (!(why instanceof DeploymentException)) {
      LOG.warn("What {} asked for cannot be done", Replies.sender(message), why);
    }
    supervisor.refuse(message, ACLMessage.REFUSE, String.valueOf(why.getMessage()));
  }

  public void done(ACLMessage message, String sentence) {
    supervisor.reply(
        message,
        ACLMessage.INFORM,
        Words.content("inform", Words.named("text", Words.text(sentence))));
  }

  /** Where the description that a request brings was read. */
  public static String source(Words words) {
    return words.string("file").orElse("the description");
  }
}
