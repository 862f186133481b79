package org.maestro.agents.device;

import jade.core.AID;
import jade.core.Agent;
import jade.core.AgentContainer;
import jade.core.AgentManager;
import jade.core.ContainerID;
import jade.core.MainContainer;
import jade.core.NotFoundException;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;

/**
 * One container as its agents, and who runs it, see it. Made before the container is, which
 * attaches itself. Any thread may use it.
 */
public final class Host {
  private volatile Optional<Surroundings> surroundings = Optional.empty();
  private volatile Optional<AgentContainer> container = Optional.empty();
  private final List<AgentManager.Listener> watchers = new CopyOnWriteArrayList<>();

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
  public Surroundings surroundings() {
    return surroundings.orElseThrow(
        () ->
            new IllegalStateException(
                "The container "
                    + container.map(c -> c.getID().getName()).orElse("here")
                    + " takes no generic agents; choose one that ./maestro agents --containers"
                    + " lists as hosting."));
  }

  /**
   * The container has ended its agents. JADE leaves its own two of the main one running, and keeps
   * one of them until the process ends: it must not hold all that the platform had.
   */
  void end() {
    container.ifPresent(
        own -> {
          end(own, own.getDefaultDF());
          end(own, own.getAMS());
        });
    manager().ifPresent(manager -> watchers.forEach(manager::removeListener));
    watchers.clear();
    surroundings = Optional.empty();
  }

  private static void end(AgentContainer container, AID name) {
    Agent agent = container.acquireLocalAgent(name);
    if (agent != null) {
      try {
        agent.doDelete();
      } finally {
        container.releaseLocalAgent(name);
      }
    }
  }

  /** The platform's own manager of agents; empty in any container but the main one. */
  public Optional<AgentManager> manager() {
    return container
        .map(AgentContainer::getMain)
        .filter(AgentManager.class::isInstance)
        .map(AgentManager.class::cast);
  }

  /**
   * Whether a container of the platform has that name, or JADE has not yet let go of the name of
   * one that ended. Only the main container knows.
   */
  public boolean keeps(String name) {
    return container.map(AgentContainer::getMain).filter(main -> keeps(main, name)).isPresent();
  }

  private static boolean keeps(MainContainer main, String name) {
    try {
      main.getContainerNode(new ContainerID(name, null));
      return true;
    } catch (NotFoundException e) {
      return false;
    }
  }

  /**
   * Tells what happens in the platform, for as long as the container lives.
   *
   * @throws IllegalStateException in any container but the main one
   */
  public void watch(AgentManager.Listener watcher) {
    AgentManager manager =
        manager()
            .orElseThrow(
                () -> new IllegalStateException("Only a main container knows what happens."));
    watchers.add(watcher);
    manager.addListener(watcher);
  }
}
