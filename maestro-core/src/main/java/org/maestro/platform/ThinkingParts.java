package org.maestro.platform;

import jade.wrapper.AgentContainer;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.agents.CopyAgent;
import org.maestro.agents.GroupAgent;
import org.maestro.agents.LanguageAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.goals.Past;
import org.maestro.agents.goals.ReasoningServices;
import org.maestro.agents.knowledge.KnowledgeCopy;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.dialogue.Dialogues;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.planning.api.Planner;
import org.maestro.platform.jade.JadeRuntime;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Parts of the central agent that are agents themselves, in a container that has joined (ADE, 3;
 * A15): the understanding of what people say, and the pursuit of goals. What is known stays with
 * the knowledge agent; here there is a copy of it.
 */
final class ThinkingParts implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(ThinkingParts.class);

  private final CollectiveKnowledge knowledge;

  private ThinkingParts(CollectiveKnowledge knowledge) {
    this.knowledge = knowledge;
  }

  /** Begins them, and an agent that keeps their copy. */
  static ThinkingParts begin(
      AgentContainer container,
      String copyName,
      AgentTime time,
      Home home,
      Set<ThinkingPart> parts,
      Planner planner) {
    CollectiveKnowledge own = new CollectiveKnowledge(home, time.clock());
    try {
      begin(container, copyName, time, home, new KnowledgeCopy(own), parts, planner);
    } catch (RuntimeException e) {
      own.close();
      throw e;
    }
    return new ThinkingParts(own);
  }

  private static void begin(
      AgentContainer container,
      String copyName,
      AgentTime time,
      Home home,
      KnowledgeCopy copy,
      Set<ThinkingPart> parts,
      Planner planner) {
    JadeRuntime.start(container, copyName, new CopyAgent(Birth.of(container), time, copy));
    if (parts.contains(ThinkingPart.LANGUAGE)) {
      JadeRuntime.start(
          container, AgentNames.LANGUAGE, new LanguageAgent(Birth.of(container), time, copy));
    }
    if (parts.contains(ThinkingPart.GOALS)) {
      JadeRuntime.start(
          container,
          AgentNames.GOALS,
          new GroupAgent(
              Birth.of(container),
              time,
              new ReasoningServices(copy, planner, Duration.ZERO),
              all(home),
              ThinkingParts::told,
              Past.none(),
              new Dialogues(copy::home, copy::snapshot, time.clock()::instant),
              Spokesmen.BY_NAME));
    }
  }

  /** All devices of the home, and no goals but those that it is asked for. */
  private static Group all(Home home) {
    return new Group(
        new Individual(
            AgentNames.GOALS, "urn:maestro:" + AgentNames.GOALS, "the goals", Set.of(), Map.of()),
        Optional.empty(),
        home.devices().keySet(),
        Optional.empty(),
        List.of());
  }

  private static void told(StoryEntry entry) {
    LOG.info("{}: {}", entry.goalId(), entry.text());
  }

  /** After the agents have ended. */
  @Override
  public void close() {
    knowledge.close();
  }
}
