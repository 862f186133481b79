package org.maestro.agents.calls;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.maestro.agents.content.ArbitrationWords;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.HeldElsewhere;
import org.maestro.members.ComponentArbiter;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Which manager of goals may use the components of a generic agent's member, agreed on in messages
 * (ADE, 6; A94). A manager that does not answer what it is asked is not there, and has nothing any
 * more. Agent thread only.
 */
public final class Arbitration {
  private static final Logger LOG = LoggerFactory.getLogger(Arbitration.class);
  private static final Duration ANSWERS_WITHIN = Duration.ofSeconds(5);

  private final MaestroAgent agent;
  private final String member;
  private final ComponentArbiter arbiter = new ComponentArbiter(new ByMessages());
  private final Map<String, AID> managers = new TreeMap<>();
  private Consumer<Words> ownGoals = words -> {};
  private Consumer<ComponentWant> ownYields = want -> {};

  public Arbitration(MaestroAgent agent, String member) {
    this.agent = agent;
    this.member = member;
  }

  /** How the agent's own goals hear of what others want, and of what they have got. */
  public void ownManager(Consumer<ComponentWant> yields, Consumer<Words> heard) {
    ownYields = yields;
    ownGoals = heard;
  }

  private String own() {
    return agent.getLocalName();
  }

  /**
   * Who has what a step needs; empty: the manager has it all, until it is {@link #used} and beyond.
   */
  Optional<HeldElsewhere> use(AID manager, String goalId, FeatureType feature) {
    managers.put(manager.getLocalName(), manager);
    return arbiter.use(manager.getLocalName(), goalId, components(feature), isBrief(feature));
  }

  Optional<HeldElsewhere> useOwn(String goalId, FeatureType feature) {
    return arbiter.use(own(), goalId, components(feature), isBrief(feature));
  }

  /** What was begun has come to its end. */
  void used(FeatureType feature) {
    if (isBrief(feature)) {
      arbiter.used(components(feature));
    }
  }

  /** What goes on until it is cancelled is no reason to wait for who is gone. */
  private static boolean isBrief(FeatureType feature) {
    return !feature.continuous();
  }

  private static Set<String> components(FeatureType feature) {
    return Set.copyOf(feature.occupies());
  }

  /** A manager wants components that another has, or wants them no more. */
  public void want(ACLMessage message, Words words) {
    String manager = message.getSender().getLocalName();
    managers.put(manager, message.getSender());
    want(manager, words);
  }

  private void want(String manager, Words words) {
    ArbitrationWords.want(words, agent.clock().now())
        .ifPresentOrElse(
            want -> arbiter.want(manager, want),
            () -> words.string("goal").ifPresent(goal -> arbiter.wantNoMore(manager, goal)));
  }

  void wantOwn(ComponentWant want) {
    arbiter.want(own(), want);
  }

  void wantOwnNoMore(String goalId) {
    arbiter.wantNoMore(own(), goalId);
  }

  public void giveBack(ACLMessage message, Words words) {
    giveBack(message.getSender().getLocalName(), new TreeSet<>(words.strings("components")));
  }

  void giveBackOwn(Set<String> components) {
    giveBack(own(), components);
  }

  private void giveBack(String manager, Set<String> components) {
    arbiter.giveBack(manager, components);
  }

  /** Who has ordered or wanted something has written before. */
  private AID address(String manager) {
    return Objects.requireNonNull(managers.get(manager));
  }

  /** The way to the managers; to the agent's own goals there are no messages. */
  private final class ByMessages implements ComponentArbiter.Managers {

    @Override
    public void askToYield(String holder, String by, ComponentWant want) {
      if (holder.equals(own())) {
        agent.tell(() -> ownYields.accept(want));
        return;
      }
      agent.ask(
          agent.message(
              ACLMessage.REQUEST,
              address(holder),
              ArbitrationWords.yieldTo(want, agent.clock().now())),
          ANSWERS_WITHIN,
          reply -> {
            if (reply.getPerformative() != ACLMessage.INFORM) {
              LOG.info(
                  "{}: {} has what {} wants, and does not answer ({}); it is given away",
                  member,
                  holder,
                  want.goalId(),
                  Replies.reason(reply).orElse("nothing is heard"));
              arbiter.gone(holder);
            }
          });
    }

    @Override
    public void wantedNoMore(String holder, String goalId) {
      tell(holder, ArbitrationWords.wantedNoMore(goalId, member));
    }

    @Override
    public void got(String manager, Set<String> components) {
      tell(manager, ArbitrationWords.got(member, components));
    }

    private void tell(String manager, Content news) {
      if (manager.equals(own())) {
        agent.tell(() -> ownGoals.accept(Words.of(news)));
      } else {
        agent.send(agent.message(ACLMessage.INFORM, address(manager), news));
      }
    }
  }
}
