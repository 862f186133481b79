package org.maestro.platform;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.function.Function;
import org.maestro.agents.GroupAgent;
import org.maestro.agents.lives.AgentLives;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Group;

/**
 * The agents of rooms and of other groups: those of the home's file, and those that are added while
 * it runs (ADE, 6; A96). Any thread may use it.
 */
final class GroupAgents {
  private final KnowledgeBase knowledge;
  private final AgentLives lives;
  private final MemberAgents agents;
  private final Function<Group, GroupAgent> making;
  private final Map<String, GroupAgent> agentByGroup = new ConcurrentSkipListMap<>();

  /**
   * @param making makes the agent of a group, which has not begun
   */
  GroupAgents(
      KnowledgeBase knowledge,
      AgentLives lives,
      MemberAgents agents,
      Function<Group, GroupAgent> making) {
    this.knowledge = knowledge;
    this.lives = lives;
    this.agents = agents;
    this.making = making;
  }

  /** Those that stand in the home begin. */
  void beginAll() {
    knowledge.home().groups().values().forEach(this::start);
  }

  /** One more begins, and is known to all others. */
  void begin(Group group) {
    knowledge.admit(group);
    start(group);
  }

  private void start(Group group) {
    GroupAgent agent = making.apply(group);
    agentByGroup.put(group.id(), agent);
    lives.listen(agent);
    agents.begin(group, agent);
  }

  /**
   * One ends for good; what is said in its room is heard as where no agent listens.
   *
   * @return false when there is none of that name
   */
  boolean end(String group) {
    Optional<GroupAgent> agent = Optional.ofNullable(agentByGroup.remove(group));
    agent.ifPresent(
        one -> {
          knowledge.dismiss(group);
          lives.leave(one);
          agents.end(group);
        });
    return agent.isPresent();
  }
}
