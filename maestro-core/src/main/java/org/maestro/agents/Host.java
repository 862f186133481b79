package org.maestro.agents;

import jade.core.AgentContainer;
import jade.core.AgentManager;
import java.util.Optional;

/**
 * One container as its agents, and who runs it, see it. Made before the container is, which
 * attaches itself. Any thread may use it.
 */
public final class Host {
  private volatile Optional<Surroundings> surroundings = Optional.empty();
  private volatile Optional<AgentContainer> container = Optional.empty();

  /** Of a container that takes no generic agents, as long as nothing is given for them. */
  public Host() {
    // What it gives comes later.
  }

  public Host(Surroundings surroundings) {
    give(surroundings);
  }

  /** From now on generic agents can live in the container. */
  public void give(Surroundings given) {
    surroundings = Optional.of(given);
  }

  void attach(AgentContainer own) {
    container = Optional.of(own);
  }

  /**
   * @throws IllegalStateException with one sentence in a container that takes no generic agents
   */
  Surroundings surroundings() {
    return surroundings.orElseThrow(
        () ->
            new IllegalStateException(
                "The container "
                    + container.map(c -> c.getID().getName()).orElse("here")
                    + " takes no generic agents; choose one that ./maestro agents --containers lists as hosting."));
  }

  /** The platform's own manager of agents; empty in any container but the main one. */
  public Optional<AgentManager> manager() {
    return container
        .map(AgentContainer::getMain)
        .filter(AgentManager.class::isInstance)
        .map(AgentManager.class::cast);
  }
}
