package org.maestro.agents.knowledge;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What a copy of the collective knowledge is told, and what is told for it. All is asked for again
 * now and then: what is seen once more is no news, and must not grow too old here. Agent thread
 * only.
 */
public final class CopiedBeliefs {
  private static final Logger LOG = LoggerFactory.getLogger(CopiedBeliefs.class);
  private static final Duration BETWEEN_REVIEWS = Duration.ofSeconds(15);
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(10);

  private final MaestroAgent agent;
  private final KnowledgeCopy copy;
  private Optional<AID> memory = Optional.empty();
  private Optional<String> subscription = Optional.empty();
  private Clock.Timer review = () -> {};

  public CopiedBeliefs(MaestroAgent agent, KnowledgeCopy copy) {
    this.agent = agent;
    this.copy = copy;
    copy.whenLearnt(content -> agent.tell(() -> tell(content)));
  }

  /**
   * From now on this agent tells what is known.
   *
   * @param its empty: nobody does
   */
  public void from(Optional<AID> its) {
    end();
    memory = its;
    its.ifPresent(this::begin);
  }

  private void begin(AID its) {
    subscription =
        Optional.of(
            agent
                .conversations()
                .subscribe(
                    agent.message(
                        ACLMessage.SUBSCRIBE,
                        its,
                        Words.content("subscribe", Words.named("beliefs", List.of()))),
                    this::heard));
    reviewLater();
  }

  private void reviewLater() {
    review =
        agent
            .clock()
            .schedule(
                BETWEEN_REVIEWS, agent.getLocalName(), () -> agent.tell(this::askForEverything));
  }

  private void askForEverything() {
    memory.ifPresent(
        its -> {
          agent.ask(
              agent.message(ACLMessage.QUERY_REF, its, Words.content("query-ref")),
              ANSWER_WITHIN,
              this::heard);
          reviewLater();
        });
  }

  private void heard(ACLMessage message) {
    if (message.getPerformative() == ACLMessage.INFORM) {
      copy.heard(Words.parse(message.getContent()));
    } else if (message.getPerformative() != ACLMessage.AGREE) {
      LOG.warn("{} is not told what is known: {}", agent.getLocalName(), message.getContent());
    }
  }

  private void tell(Content learnt) {
    memory.ifPresent(its -> agent.send(agent.message(ACLMessage.INFORM, its, learnt)));
  }

  /** Nobody is listened to any more. */
  public void end() {
    review.cancel();
    subscription.ifPresent(agent.conversations()::close);
    subscription = Optional.empty();
    memory = Optional.empty();
  }
}
