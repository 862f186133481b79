package org.maestro.agents;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.function.Consumer;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;

/**
 * The desk at which people (and programs for them) state goals and ask questions (M25). Its methods
 * may be called by any thread; the answers come on the agent's.
 */
public final class DeskAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;
  private static final Duration NO_END = Duration.ofDays(365);

  public DeskAgent(AgentTime time) {
    super(time);
  }

  @Override
  protected void received(ACLMessage message) {
    refuse(
        message,
        ACLMessage.NOT_UNDERSTOOD,
        "The desk answers no questions; state goals to the CCA by request.");
  }

  /** States a goal; AGREE brings its id, the last reply how it ended. */
  public void requestGoal(Formula goal, Consumer<ACLMessage> replies) {
    request(
        ACLMessage.REQUEST,
        CoordinatorAgent.NAME,
        NO_END,
        replies,
        Words.content("initCNP", Words.named("goal", Words.formula(goal))));
  }

  /** Asks an agent of this platform; exactly one final reply follows. */
  public void request(
      int performative,
      String agent,
      Duration timeout,
      Consumer<ACLMessage> replies,
      Content... contents) {
    tell(() -> ask(message(performative, aid(agent), contents), timeout, replies));
  }

  /** Listens to a goal's story, from its beginning. */
  public void follow(String goalId, Consumer<ACLMessage> lines) {
    tell(
        () ->
            conversations()
                .subscribe(
                    message(
                        ACLMessage.SUBSCRIBE,
                        aid(CoordinatorAgent.NAME),
                        Words.content("subscribe", Words.named("story", Words.name(goalId)))),
                    lines));
  }

  private AID aid(String localName) {
    return getAID(localName);
  }
}
