package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.sl.Content;
import org.maestro.sl.SlSyntaxException;

/**
 * The requests of others to the central agent about agents and containers: it hands them to the
 * supervisor, and the answers back. Agent thread only.
 */
public final class DeploymentRequests {
  private static final Duration LONGEST = Duration.ofMinutes(2);

  private final MaestroAgent agent;

  public DeploymentRequests(MaestroAgent agent) {
    this.agent = agent;
  }

  public void forward(ACLMessage message, Content content) {
    if (message.getPerformative() != ACLMessage.REQUEST) {
      agent.refuse(
          message,
          ACLMessage.NOT_UNDERSTOOD,
          "perform is understood in a request only, and this message is another: "
              + ACLMessage.getPerformative(message.getPerformative())
              + ".");
      return;
    }
    agent.ask(
        agent.message(ACLMessage.REQUEST, agent.getAID(AgentNames.SUPERVISOR), content),
        LONGEST,
        answer -> answer(message, answer));
  }

  private void answer(ACLMessage message, ACLMessage answer) {
    try {
      agent.reply(
          message,
          answer.getPerformative(),
          Words.parse(answer.getContent()).toArray(Content[]::new));
    } catch (SlSyntaxException e) {
      agent.refuse(
          message, ACLMessage.FAILURE, "There is no supervisor on this platform to do that.");
    }
  }
}
