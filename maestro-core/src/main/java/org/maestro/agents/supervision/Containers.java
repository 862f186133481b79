package org.maestro.agents.supervision;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.agents.HostAgent;
import org.maestro.agents.content.Addition;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.pulse.Pulse;
import org.maestro.agents.runtime.Caller;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.ContainerStart;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Content;

/**
 * The containers and agents of the platform. Any thread may call. What cannot be done throws a
 * RuntimeException with one sentence; what waits for JADE says so.
 */
public interface Containers {
  /**
   * Waits for JADE: makes room for the container, whose name a topic's container here may have.
   *
   * @param asker the agent that asks for it, and lives as long as the process that is to have it
   */
  Handover admit(ContainerStart container, String asker);

  /** Waits for JADE: the container is there; returns the agents that begin or are to move there. */
  Welcome welcome(ContainerStart container);

  /** Waits for JADE; returns who was started: all, or none. */
  List<Newcomer> add(Addition addition);

  /** Takes in an agent that was started by other means; checks a password, which takes a while. */
  void startedByHand(AgentStart start, Caller caller, Optional<StartWords.Shown> shown);

  /** Requires that the caller's process may have agents: that of a guest may not. */
  void requireHost(Caller caller);

  /** Returns whom to ask. */
  AgentStart requireMovable(String agent, String container);

  void moved(String agent, String container);

  /**
   * How the agent is to be configured.
   *
   * @param source how faults call the description
   */
  AgentStart reconfigured(String agent, String description, String source);

  void configured(AgentStart start);

  /** Waits for JADE. */
  void remove(String agent);

  /** Waits for JADE: starts the central agent again; returns false when it is there. */
  boolean reviveCoordinator();

  /**
   * A line for each agent, and for each container.
   *
   * @param services what the directory facilitator has, by agent
   */
  List<Content> tables(Map<String, ? extends Set<String>> services);

  /** Whether there is an agent of that name. */
  boolean isThere(String agent);

  /** The home as it is now, which says who may ask whom. */
  Home home();

  /**
   * A process offers itself as a host for agents, by its {@link HostAgent}.
   *
   * @return where the bus is; empty: it cannot be reached from elsewhere
   * @throws IllegalArgumentException with one sentence when something that it provides cannot be
   *     read
   */
  default Optional<Handover> offered(String host, List<String> provides) {
    return Optional.empty();
  }

  /** The supervisor is there, and can hear who is alive. */
  default void watchOver(Pulse pulse) {
    // Where nobody is missed nobody is watched.
  }
}
