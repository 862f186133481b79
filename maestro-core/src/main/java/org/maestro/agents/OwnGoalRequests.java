package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import org.maestro.sl.Content;

/** Answers what others ask of an agent's own goals. Agent thread only. */
final class OwnGoalRequests {
  private final MaestroAgent agent;
  private final OwnGoals goals;

  OwnGoalRequests(MaestroAgent agent, OwnGoals goals) {
    this.agent = agent;
    this.goals = goals;
  }

  void cancel(ACLMessage message, Words words) {
    String id = words.string("goal").orElse("");
    if (goals.cancel(id, Replies.sender(message))) {
      agent.reply(
          message,
          ACLMessage.INFORM,
          Words.content("inform", Words.named("cancelled", Words.name(id))));
    } else {
      agent.refuse(
          message,
          ACLMessage.REFUSE,
          agent.getLocalName() + " has no goal " + Replies.shortened(id) + " that goes on.");
    }
  }

  void list(ACLMessage message) {
    agent.reply(
        message,
        ACLMessage.INFORM,
        goals.statuses().stream().map(GoalWords::status).toArray(Content[]::new));
  }
}
