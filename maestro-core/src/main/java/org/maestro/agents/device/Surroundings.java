package org.maestro.agents.device;

import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import org.maestro.agents.goals.Past;
import org.maestro.agents.goals.ReasoningServices;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Story;
import org.maestro.ontology.home.Device;
import org.maestro.rats.link.RatsLink;

/**
 * The environment that a container gives to the generic agents that live in it: whatever else they
 * are, travels with them.
 *
 * @param describedBy reads a description (first argument) of a member (second); throws a
 *     RuntimeException with one sentence when it is faulty
 * @param mind with which they pursue goals of their own; empty where the collective knowledge is
 *     out of reach
 * @param story where they tell of these
 * @param past with which these go on
 */
public record Surroundings(
    AgentTime time,
    RatsLink link,
    BiFunction<String, String, Device> describedBy,
    Optional<ReasoningServices> mind,
    Story story,
    Past past) {

  /** Of a container from which the collective knowledge is reached by messages only. */
  public Surroundings(
      AgentTime time, RatsLink link, BiFunction<String, String, Device> describedBy) {
    this(time, link, describedBy, Optional.empty(), entry -> {}, Past.none());
  }

  /** The same, but with another way to the bus. */
  public Surroundings with(RatsLink other) {
    return new Surroundings(time, other, describedBy, mind, story, past);
  }

  /** For an agent that has lived elsewhere: what it was at then is no matter of a journal. */
  public Surroundings afterMove() {
    return new Surroundings(
        time, link, describedBy, mind, story, new Past(past.journal(), Recovery.NOTHING, Map.of()));
  }
}
