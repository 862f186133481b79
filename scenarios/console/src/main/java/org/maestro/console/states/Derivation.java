package org.maestro.console.states;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.pulse.Condition;
import org.maestro.rats.protocol.MemberStatus;

/** The standings of a platform's parts, each derived from what it depends on. */
final class Derivation {
  private final Observed observed;
  private final Map<String, Derived> containers = new HashMap<>();

  Derivation(Observed observed) {
    this.observed = observed;
    observed.containers().forEach(one -> containers.put(one.name(), container(one)));
  }

  Derived bus() {
    return observed.bus().map(why -> Derived.of(Standing.LOST, why)).orElse(Derived.WELL);
  }

  Derived journal() {
    if (!observed.keepsJournal()) {
      return Derived.of(
          Standing.OFF, "There is none: goals end with the process; --data DIR keeps them.");
    }
    return observed.journal().map(why -> Derived.of(Standing.FAILING, why)).orElse(Derived.WELL);
  }

  Derived container(Observed.Container container) {
    return switch (container.condition()) {
      case ALIVE -> Derived.WELL;
      case SUSPECTED ->
          Derived.of(
              Standing.DOUBTFUL,
              "It has given no sign of life for %s or longer; after %s it is given up."
                  .formatted(
                      Seconds.of(observed.timing().suspectedAfter()),
                      Seconds.of(observed.timing().lostAfter())));
      case LOST ->
          Derived.of(
              Standing.LOST,
              "It has given no sign of life for %s or longer, and is given up."
                  .formatted(Seconds.of(observed.timing().lostAfter())));
    };
  }

  /** Of one that is not there any more. */
  Derived gone() {
    return Derived.of(
        Standing.LOST,
        "Its process has ended, was killed, or cannot be reached; its agents begin elsewhere, where one fits.");
  }

  Derived agent(Observed.Agent agent) {
    if (!agent.isThere()) {
      return Derived.of(Standing.LOST, absence(agent));
    }
    Derived place = containers.getOrDefault(agent.container(), Derived.WELL);
    if (!place.isWell()) {
      return Derived.of(
          Standing.DOUBTFUL,
          "Its container %s is %s.".formatted(agent.container(), inWords(place)));
    }
    if (observed.idle().getOrDefault(agent.name(), Condition.ALIVE) != Condition.ALIVE) {
      return Derived.of(Standing.DOUBTFUL, "It does nothing, though its container lives.");
    }
    return Derived.WELL;
  }

  private String absence(Observed.Agent agent) {
    if (agent.name().equals(AgentNames.COORDINATOR)) {
      return "It was ended; ./maestro revive starts it again.";
    }
    return agent.members().stream().anyMatch(observed.homeless()::contains)
        ? "No host that is there provides what it needs."
        : "It is not there; another is to begin in its place.";
  }

  Derived member(String member, Observed.Agent agent) {
    if (observed.bus().isPresent()) {
      return Derived.of(Standing.UNREACHABLE, "There is no connection to the bus.");
    }
    Derived speaker = agent(agent);
    if (!speaker.isWell()) {
      return Derived.of(
          Standing.UNREACHABLE,
          "Its agent %s is %s: %s"
              .formatted(agent.name(), inWords(speaker), speaker.why().orElseThrow()));
    }
    Optional<String> refusal = Optional.ofNullable(observed.refused().get(member));
    return refusal
        .map(why -> Derived.of(Standing.FAILING, "What it says of itself is refused: " + why))
        .orElseGet(() -> presence(member));
  }

  private Derived presence(String member) {
    MemberStatus.Phase phase = observed.phases().get(member);
    if (phase == null) {
      return Derived.of(Standing.LOST, "It was not heard of on the bus.");
    }
    return switch (phase) {
      case READY -> Derived.WELL;
      case INIT -> Derived.of(Standing.FAILING, "It begins, and takes no calls yet.");
      case DISCONNECTED -> Derived.of(Standing.LOST, "It has taken its leave of the bus.");
      case LOST -> Derived.of(Standing.LOST, "It has left the bus without taking its leave.");
    };
  }

  static String inWords(Derived derived) {
    return derived.standing().name().toLowerCase(Locale.ROOT);
  }
}
