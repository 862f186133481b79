package org.maestro.platform;

import jade.wrapper.AgentContainer;
import jade.wrapper.AgentController;
import jade.wrapper.StaleProxyException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.function.Function;
import org.maestro.agents.MaestroAgent;

/**
 * The abstraction containers of this process, one for each topic (M70), and the agents in them. Any
 * thread may call; one at a time.
 */
final class TopicContainers {
  private final Function<String, AgentContainer> newContainer;
  private final Map<String, AgentContainer> containerByTopic = new LinkedHashMap<>();
  private final Map<String, Placed> placedByMember = new LinkedHashMap<>();
  private final Map<String, String> topicByMemberElsewhere = new ConcurrentSkipListMap<>();
  private final Set<String> topicsElsewhere = new LinkedHashSet<>();

  /** Members whose agents were ended here, until JADE says so: it may say it late. */
  private final Set<String> endingHere = new ConcurrentSkipListSet<>();

  private record Placed(String topic, AgentController agent) {}

  TopicContainers(Function<String, AgentContainer> newContainer) {
    this.newContainer = newContainer;
  }

  /**
   * Starts the agent in its topic's container, unless the member has one already or the topic is
   * held elsewhere.
   */
  synchronized boolean place(String member, String topic, Function<String, MaestroAgent> newAgent) {
    if (placedByMember.containsKey(member) || topicsElsewhere.contains(topic)) {
      return false;
    }
    AgentContainer container = containerByTopic.computeIfAbsent(topic, newContainer);
    AgentController agent = JadeRuntime.start(container, member, newAgent.apply(member));
    placedByMember.put(member, new Placed(topic, agent));
    return true;
  }

  /**
   * Ends the topic's container here, so that another process can take its members, and its name;
   * returns them. JADE may take some seconds to end it.
   */
  Optional<List<String>> release(String topic) {
    Optional<Released> released = giveUp(topic);
    released.ifPresent(gone -> JadeRuntime.endNow(gone.container()));
    return released.map(Released::members);
  }

  private record Released(AgentContainer container, List<String> members) {}

  private synchronized Optional<Released> giveUp(String topic) {
    AgentContainer container = containerByTopic.remove(topic);
    if (container == null) {
      return Optional.empty();
    }
    List<String> members = new ArrayList<>();
    placedByMember.forEach(
        (member, placed) -> {
          if (placed.topic().equals(topic)) {
            members.add(member);
          }
        });
    for (String member : members) {
      endingHere.add(member);
      try {
        placedByMember.remove(member).agent().kill();
      } catch (StaleProxyException e) {
        endingHere.remove(member);
      }
    }
    topicsElsewhere.add(topic);
    members.forEach(member -> topicByMemberElsewhere.put(member, topic));
    return Optional.of(new Released(container, List.copyOf(members)));
  }

  /**
   * Whether the agent that ended, as JADE tells once for each, was the one in another process. Any
   * thread may ask at any time.
   */
  boolean endedElsewhere(String member) {
    return !endingHere.remove(member) && topicByMemberElsewhere.containsKey(member);
  }

  /** The process that had the member's agent has lost it: the agent and its topic come back. */
  synchronized void reclaim(String member, String topic, Function<String, MaestroAgent> newAgent) {
    topicByMemberElsewhere.remove(member);
    topicsElsewhere.remove(topic);
    place(member, topic, newAgent);
  }

  /** The member's agent lives in a container of another process now. */
  synchronized void movedTo(String member, String container) {
    topicByMemberElsewhere.put(member, container);
  }

  synchronized List<String> topics() {
    return List.copyOf(containerByTopic.keySet());
  }

  /** Container name by member, also of those that another process has taken. */
  synchronized Map<String, String> places() {
    Map<String, String> places = new LinkedHashMap<>();
    placedByMember.forEach((member, placed) -> places.put(member, placed.topic()));
    places.putAll(topicByMemberElsewhere);
    return places;
  }

  /** No agent is placed any more; returns the containers of this process, which are to be ended. */
  synchronized List<AgentContainer> close() {
    List<AgentContainer> containers = List.copyOf(containerByTopic.values());
    containerByTopic.clear();
    placedByMember.clear();
    topicByMemberElsewhere.clear();
    return containers;
  }
}
