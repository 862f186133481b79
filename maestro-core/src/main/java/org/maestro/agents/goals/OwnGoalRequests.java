package org.maestro.agents.goals;

import jade.lang.acl.ACLMessage;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.GoalWords;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.SpeechWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Respondent;
import org.maestro.sl.Content;

/** Answers what others ask of an agent's own goals. Agent thread only. */
public final class OwnGoalRequests {
  private final MaestroAgent agent;
  private final OwnGoals goals;

  public OwnGoalRequests(MaestroAgent agent, OwnGoals goals) {
    this.agent = agent;
    this.goals = goals;
  }

  public void cancel(ACLMessage message, Words words) {
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

  /**
   * An answer to a question of one of its scripts. The central agent passes it on, who knows
   * whether the one may answer for whom it speaks; nobody else is heard.
   */
  public void answer(ACLMessage message, Words words) {
    if (!Replies.sender(message).equals(AgentNames.COORDINATOR)) {
      agent.refuse(
          message,
          ACLMessage.REFUSE,
          "%s takes answers from the %s only; answer there."
              .formatted(agent.getLocalName(), AgentNames.COORDINATOR));
      return;
    }
    String question = words.string("question").orElse("");
    goals.answer(
        question,
        words.string("text").orElse(""),
        new Respondent(words.string("for").orElse(AgentNames.COORDINATOR), words.string("person")),
        refusal ->
            agent.reply(
                message,
                refusal.isPresent() ? ACLMessage.REFUSE : ACLMessage.INFORM,
                SpeechWords.verdict(question, refusal)));
  }

  public void list(ACLMessage message) {
    agent.reply(
        message,
        ACLMessage.INFORM,
        goals.statuses().stream().map(GoalWords::status).toArray(Content[]::new));
  }
}
