package org.maestro.coordination.api;

import java.time.Duration;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.planning.api.Planner;
import org.maestro.rats.time.Clock;

/**
 * Everything outside that coordination uses.
 *
 * @param comeback for so long after a member was lost it is waited for, before a goal that misses
 *     it is given up; simulated time, since devices live in the world's
 */
public record Ports(
    KnowledgeBase knowledge,
    Planner planner,
    ContractNet contractNet,
    ActionDispatcher dispatcher,
    Thinking thinking,
    Clock clock,
    Story story,
    Journal journal,
    Duration comeback) {

  /** Twice the time in which members are to be back once their broker is. */
  public static final Duration USUAL_COMEBACK = Duration.ofSeconds(10);

  public Ports(
      KnowledgeBase knowledge,
      Planner planner,
      ContractNet contractNet,
      ActionDispatcher dispatcher,
      Thinking thinking,
      Clock clock,
      Story story,
      Journal journal) {
    this(
        knowledge,
        planner,
        contractNet,
        dispatcher,
        thinking,
        clock,
        story,
        journal,
        USUAL_COMEBACK);
  }

  /** Of a coordinator that keeps no journal. */
  public Ports(
      KnowledgeBase knowledge,
      Planner planner,
      ContractNet contractNet,
      ActionDispatcher dispatcher,
      Thinking thinking,
      Clock clock,
      Story story) {
    this(knowledge, planner, contractNet, dispatcher, thinking, clock, story, Journal.none());
  }

  public Ports with(Planner other) {
    return new Ports(
        knowledge, other, contractNet, dispatcher, thinking, clock, story, journal, comeback);
  }

  public Ports with(ActionDispatcher other) {
    return new Ports(
        knowledge, planner, contractNet, other, thinking, clock, story, journal, comeback);
  }

  /** For work that can wait a moment. */
  public Ports patient() {
    return new Ports(
        knowledge,
        planner,
        contractNet,
        dispatcher,
        thinking.patient(),
        clock,
        story,
        journal,
        comeback);
  }
}
