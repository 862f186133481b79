package org.maestro.agents.centre;

import jade.lang.acl.ACLMessage;
import java.util.Optional;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Caller;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.Once;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.ontology.home.Home;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Those whom the central agent believes what they report of members and of goals of their own: the
 * agents that stand for them (ADE, 3.1; A23). What others report counts for nothing; they are told
 * why, and so are the log and the stories. Agent thread only.
 */
public final class Reporters {
  private static final Logger LOG = LoggerFactory.getLogger(Reporters.class);

  private final MaestroAgent agent;
  private final Spokesmen spokesmen;
  private final Once told = new Once();

  public Reporters(MaestroAgent agent, Spokesmen spokesmen) {
    this.agent = agent;
    this.spokesmen = spokesmen;
  }

  /** Whether who reports this is believed; who is not is told so. */
  public boolean areHeard(
      ACLMessage message, Words words, Home home, Coordinator coordinator, ToldStories stories) {
    Optional<String> subject =
        words.string("member").or(() -> words.string("goal").map(GoalId::pursuer));
    Optional<String> objection =
        subject.flatMap(one -> spokesmen.objection(Caller.of(message, agent.getHap()), one));
    objection.ifPresent(
        why -> {
          agent.refuse(message, ACLMessage.REFUSE, why);
          if (told.isNew(why)) {
            LOG.warn("A report is not believed: {}", Replies.shortened(why));
          }
          if (subject.filter(one -> isOfTheHome(home, one)).isPresent()) {
            tell(words, Replies.shortened(why).replaceAll("\\.$", ""), coordinator, stories);
          }
        });
    return objection.isEmpty();
  }

  private static boolean isOfTheHome(Home home, String subject) {
    return home.devices().containsKey(subject) || home.groups().containsKey(subject);
  }

  /** In the story of the goal that it names, or of all that are pursued. */
  private static void tell(
      Words words, String sentence, Coordinator coordinator, ToldStories stories) {
    Optional<String> goal = words.string("goal").filter(coordinator::hasGoal);
    if (goal.isPresent()) {
      stories.misconduct(goal.get(), sentence);
      return;
    }
    coordinator.goals().stream()
        .filter(status -> !status.state().isFinal())
        .map(GoalStatus::id)
        .forEach(id -> stories.misconduct(id, sentence));
  }
}
