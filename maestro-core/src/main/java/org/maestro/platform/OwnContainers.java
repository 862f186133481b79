package org.maestro.platform;

import jade.wrapper.AgentContainer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.maestro.deployment.ContainerStart;
import org.maestro.deployment.Deployment;

/** The containers for agents that a platform has in its own process, one for each topic. */
final class OwnContainers {
  private final Deployment deployment;
  private final Set<String> provides;
  private final Function<String, AgentContainer> newContainer;
  private final Map<String, AgentContainer> containers = new LinkedHashMap<>();

  /**
   * @param deployment is told of each that is made
   * @param provides what this process has for agents
   * @param newContainer joins a container of that name to the platform
   */
  OwnContainers(
      Deployment deployment, Set<String> provides, Function<String, AgentContainer> newContainer) {
    this.deployment = deployment;
    this.provides = provides;
    this.newContainer = newContainer;
  }

  /** The one of that name, which is made when it is not there. */
  synchronized AgentContainer of(String name) {
    return containers.computeIfAbsent(
        name,
        missing -> {
          AgentContainer container = newContainer.apply(missing);
          deployment.containerThere(new ContainerStart(missing, Set.of(missing), provides, true));
          return container;
        });
  }

  /** It is to end, and is none of these any more. */
  synchronized Optional<AgentContainer> release(String name) {
    return Optional.ofNullable(containers.remove(name));
  }

  /** One that was to end and has not. */
  synchronized void keep(String name, AgentContainer container) {
    containers.put(name, container);
  }

  synchronized List<String> topics() {
    return List.copyOf(containers.keySet());
  }

  /** Returns all, which are to be ended. */
  synchronized List<AgentContainer> releaseAll() {
    List<AgentContainer> all = List.copyOf(containers.values());
    containers.clear();
    return all;
  }
}
