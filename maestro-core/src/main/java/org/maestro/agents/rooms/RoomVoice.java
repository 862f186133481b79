package org.maestro.agents.rooms;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.Replies;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Argument;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Term;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The voice of a room's agent: those of its members that say sentences. Agent thread only. */
final class RoomVoice {
  private static final Logger LOG = LoggerFactory.getLogger(RoomVoice.class);

  /** The routine of members that speak. */
  private static final String SAY = "say";

  private static final Duration SPOKEN_WITHIN = Duration.ofMinutes(2);

  private final MaestroAgent agent;
  private final Supplier<Home> home;
  private final Consumer<String> spoken;
  private final Map<String, AID> voices = new TreeMap<>();
  private Optional<String> unsaid = Optional.empty();

  /**
   * @param spoken is told what was heard to its end
   */
  RoomVoice(MaestroAgent agent, Supplier<Home> home, Consumer<String> spoken) {
    this.agent = agent;
    this.home = home;
    this.spoken = spoken;
  }

  /** The feature of a member that it does by a routine of its software. */
  static Optional<String> feature(Home home, String member, String routine) {
    return Optional.ofNullable(home.devices().get(member)).stream()
        .flatMap(device -> device.features().stream())
        .filter(feature -> feature.procedure().equals(routine))
        .map(FeatureType::name)
        .findFirst();
  }

  void memberPresent(String member, AID of) {
    if (feature(home.get(), member, SAY).isPresent()) {
      voices.put(member, of);
      unsaid.ifPresent(this::say);
      unsaid = Optional.empty();
    }
  }

  void memberLost(String member) {
    voices.remove(member);
  }

  /** The agent that stands for some members is no more. */
  void agentDied(String other) {
    voices.values().removeIf(of -> of.getLocalName().equals(other));
  }

  /** Has the first member that can say a sentence; without one nothing is heard. */
  void say(String sentence) {
    for (Map.Entry<String, AID> voice : voices.entrySet()) {
      Optional<String> feature = feature(home.get(), voice.getKey(), SAY);
      if (feature.isPresent()) {
        say(voice.getKey(), voice.getValue(), feature.get(), sentence);
        return;
      }
    }
  }

  /** The same, as soon as there is a member that can. */
  void sayAtLast(String sentence) {
    if (voices.isEmpty()) {
      unsaid = Optional.of(sentence);
    } else {
      say(sentence);
    }
  }

  /** What waits to be said is said no more. */
  void forget() {
    unsaid = Optional.empty();
  }

  private void say(String member, AID of, String feature, String sentence) {
    Argument text = new Argument(new Term.Text(sentence), Optional.empty(), Map.of());
    agent.ask(
        agent.message(
            ACLMessage.REQUEST,
            of,
            Orders.plain(member, of.getLocalName(), feature, SPOKEN_WITHIN, Map.of("text", text))),
        SPOKEN_WITHIN,
        reply -> {
          if (reply.getPerformative() == ACLMessage.INFORM) {
            spoken.accept(sentence);
          } else if (reply.getPerformative() != ACLMessage.AGREE) {
            LOG.warn(
                "{} has not said \"{}\": {}",
                member,
                sentence,
                Replies.reason(reply).orElse("it does not say why"));
          }
        });
  }
}
