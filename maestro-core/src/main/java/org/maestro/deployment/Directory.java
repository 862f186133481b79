package org.maestro.deployment;

import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * The entries of the platform's tables, and since when they are so: the agents with their
 * containers and states (the global descriptor table, whose part for one container is that
 * container's local table), and the containers (Three-layered architecture, 3.3.1; M66). Told by
 * the platform's events. Any thread may use it.
 */
public final class Directory {
  private final Map<String, Entry> agents = new TreeMap<>();
  private final Map<String, Place> containers = new TreeMap<>();

  /**
   * An agent.
   *
   * @param state as the agent management system calls it: active, suspended, in transit
   * @param since when it is in this state and container
   */
  public record Entry(String agent, String container, String state, Instant since) {}

  /** A container, the address at which its process listens, and since when it is there. */
  public record Place(String name, String address, Instant since) {}

  public synchronized void born(String agent, String container, Instant at) {
    agents.put(agent, new Entry(agent, container, "active", at));
  }

  public synchronized void dead(String agent) {
    agents.remove(agent);
  }

  public synchronized void moved(String agent, String container, Instant at) {
    agents.put(agent, new Entry(agent, container, "active", at));
  }

  public synchronized void becomes(String agent, String state, Instant at) {
    agents.computeIfPresent(agent, (name, entry) -> new Entry(name, entry.container(), state, at));
  }

  public synchronized void joined(String container, String address, Instant at) {
    containers.put(container, new Place(container, address, at));
  }

  public synchronized void left(String container) {
    containers.remove(container);
    agents.values().removeIf(entry -> entry.container().equals(container));
  }

  /** The global table, by name. */
  public synchronized List<Entry> agents() {
    return List.copyOf(agents.values());
  }

  /** A container's local table, by name. */
  public synchronized List<Entry> agentsIn(String container) {
    return agents.values().stream().filter(entry -> entry.container().equals(container)).toList();
  }

  public synchronized Optional<Entry> find(String agent) {
    return Optional.ofNullable(agents.get(agent));
  }

  /** The container table, by name. */
  public synchronized List<Place> containers() {
    return List.copyOf(containers.values());
  }
}
