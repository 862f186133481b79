package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.List;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.SayWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Conversations;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.sl.Content;

/**
 * The goals of one sentence that were stated to another agent: who said it is told once that they
 * are taken on, and once how all of them ended. Agent thread only.
 */
final class StatedElsewhere {
  private final MaestroAgent agent;
  private final Said said;
  private final String means;
  private final int number;
  private final List<String> accepted = new ArrayList<>();
  private final List<String> refused = new ArrayList<>();
  private final List<Content> ends = new ArrayList<>();
  private boolean reached = true;

  /**
   * @param means the message that the sentence was understood to be
   * @param number of goals
   */
  StatedElsewhere(MaestroAgent agent, Said said, String means, int number) {
    this.agent = agent;
    this.said = said;
    this.means = means;
    this.number = number;
  }

  /** What the other agent says of one of them. */
  void answered(ACLMessage answer) {
    if (answer.getPerformative() == ACLMessage.AGREE) {
      accepted.add(Words.of(Words.parse(answer.getContent()).get(0)).string("goal").orElse(""));
      takenOn();
    } else if (answer.getPerformative() == ACLMessage.REFUSE
        || answer.getPerformative() == ACLMessage.NOT_UNDERSTOOD) {
      refused.add(reason(answer));
      takenOn();
    } else if (Replies.isFromPlatform(answer) && accepted.size() + refused.size() < number) {
      refused.add("The agent that has goals is gone; say it again in a moment.");
      takenOn();
    } else if (Conversations.isFinal(answer)) {
      reached &= answer.getPerformative() == ACLMessage.INFORM;
      ends.add(Replies.isFromPlatform(answer) ? gone() : Words.parse(answer.getContent()).get(0));
      over();
    }
  }

  private static String reason(ACLMessage answer) {
    return Replies.reason(answer).orElse("no reason given");
  }

  private static Content gone() {
    return Words.content(
        "inform",
        Words.named(
            "reason",
            Words.text(
                "The agent that pursued it is gone or cannot be reached; whether it goes on is not"
                    + " known.")));
  }

  private void takenOn() {
    if (accepted.size() + refused.size() < number) {
      return;
    }
    if (accepted.isEmpty()) {
      agent.refuse(said.message(), ACLMessage.REFUSE, refused.get(0));
    } else {
      agent.reply(said.message(), ACLMessage.AGREE, SayWords.takenOn(means, accepted));
      over();
    }
  }

  private void over() {
    if (ends.size() == accepted.size() && ends.size() + refused.size() == number) {
      refused.forEach(
          reason -> ends.add(Words.content("inform", Words.named("reason", Words.text(reason)))));
      agent.reply(
          said.message(),
          reached && refused.isEmpty() ? ACLMessage.INFORM : ACLMessage.FAILURE,
          ends.toArray(Content[]::new));
    }
  }
}
