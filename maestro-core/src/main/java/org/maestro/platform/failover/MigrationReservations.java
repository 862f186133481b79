package org.maestro.platform.failover;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.maestro.deployment.AgentStart;

/**
 * Agents of containers that other processes are about to have. They belong to whoever asked until
 * they have begun there, and are given back when that one is no more. Thread-safe.
 */
public final class MigrationReservations {
  private final Map<String, Handed> handedByContainer = new TreeMap<>();

  /** The agents that are on their way to one container. */
  private static final class Handed {
    private final String asker;
    private final List<AgentStart> starts;
    private final Map<String, String> controllerByAgent;
    private boolean admitted;
    private boolean joined;

    private Handed(
        String asker, List<AgentStart> starts, Function<AgentStart, String> controllerOf) {
      this.asker = asker;
      this.starts = new ArrayList<>(starts);
      this.controllerByAgent =
          starts.stream().collect(Collectors.toMap(AgentStart::agent, controllerOf));
    }
  }

  /**
   * The agents end here for a container that is about to join.
   *
   * @param asker the agent that asked for it
   * @param controllerOf under whose name each has called
   */
  public synchronized void begin(
      String container,
      String asker,
      List<AgentStart> starts,
      Function<AgentStart, String> controllerOf) {
    handedByContainer.put(container, new Handed(asker, starts, controllerOf));
  }

  /** Those of a container that has not joined yet. */
  public synchronized List<AgentStart> awaiting(String container) {
    Handed handed = handedByContainer.get(container);
    return handed == null || handed.joined ? List.of() : List.copyOf(handed.starts);
  }

  /** Whether the agent is on its way to a container that has not joined yet. */
  public synchronized boolean isAwaiting(String agent) {
    return handedByContainer.keySet().stream()
        .flatMap(container -> awaiting(container).stream())
        .anyMatch(start -> start.agent().equals(agent));
  }

  /** There is room for the container, or there will be none. */
  public synchronized void admitted(String container) {
    Handed handed = handedByContainer.get(container);
    if (handed != null) {
      handed.admitted = true;
      notifyAll();
    }
  }

  /** The container has joined; returns the agents that are to begin there. */
  public synchronized List<AgentStart> joined(String container) {
    List<AgentStart> starts = awaiting(container);
    Handed handed = handedByContainer.get(container);
    if (handed != null) {
      handed.joined = true;
    }
    return starts;
  }

  /** The agent is there. */
  public synchronized void begun(String agent) {
    handedByContainer
        .values()
        .removeIf(
            handed ->
                handed.joined
                    && handed.starts.removeIf(start -> start.agent().equals(agent))
                    && handed.starts.isEmpty());
  }

  /** Whether it asked for agents that have not begun yet. */
  public synchronized boolean isAsker(String agent) {
    return handedByContainer.values().stream().anyMatch(handed -> handed.asker.equals(agent));
  }

  /**
   * Whoever asked is no more. Waits until there would have been room for it.
   *
   * @return agents that have not begun, and under whose names they have called
   */
  public synchronized Map<String, String> givenUp(String asker) {
    while (handedByContainer.values().stream()
        .anyMatch(handed -> handed.asker.equals(asker) && !handed.admitted)) {
      try {
        wait();
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
        return Map.of();
      }
    }
    Map<String, String> back = new HashMap<>();
    handedByContainer
        .values()
        .removeIf(
            handed -> {
              boolean its = handed.asker.equals(asker);
              if (its) {
                handed.starts.forEach(
                    start -> back.put(start.agent(), handed.controllerByAgent.get(start.agent())));
              }
              return its;
            });
    return back;
  }
}
