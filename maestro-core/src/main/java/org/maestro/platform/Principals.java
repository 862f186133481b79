package org.maestro.platform;

import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.agents.GroupAgent;

/**
 * The agents that order others: the central one, and those that stand for groups. They are told
 * what becomes of the agents that they count on. Any thread may call.
 */
final class Principals {
  private final CentralAgent central;
  private final List<GroupAgent> groups = new CopyOnWriteArrayList<>();

  Principals(CentralAgent central) {
    this.central = central;
  }

  void add(GroupAgent group) {
    groups.add(group);
  }

  void centralEnded() {
    central.ended();
  }

  /** An agent is there, perhaps in the place of another. It tells the central agent by itself. */
  void agentBegins(String agent) {
    groups.forEach(group -> group.agentBegins(agent));
  }

  /** The agent ended, and is to begin elsewhere. */
  void agentMoves(String agent) {
    central.now().agentMoves(agent);
    groups.forEach(group -> group.agentMoves(agent));
  }

  /** The agent ended for good. */
  void agentEnded(String agent) {
    central.now().agentEnded(agent);
    groups.forEach(group -> group.agentEnded(agent));
  }
}
