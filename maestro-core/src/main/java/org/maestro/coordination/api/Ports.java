package org.maestro.coordination.api;

import java.time.Duration;
import java.util.concurrent.Executor;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.planning.api.Planner;
import org.maestro.rats.time.Clock;

/**
 * Everything outside that coordination uses.
 *
 * @param owner has the coordinator's thread do something, soon, and never behind what is thought:
 *     what is due is due also while a plan takes long. Any thread may call it
 * @param comeback for so long after a member was lost it is waited for, before a goal that misses
 *     it is given up; simulated time, since devices live in the world's
 */
public record Ports(
    KnowledgeBase knowledge,
    Planner planner,
    ContractNet contractNet,
    ActionDispatcher dispatcher,
    Thinking thinking,
    Executor owner,
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
      Executor owner,
      Clock clock,
      Story story,
      Journal journal) {
    this(
        knowledge,
        planner,
        contractNet,
        dispatcher,
        thinking,
        owner,
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
      Executor owner,
      Clock clock,
      Story story) {
    this(
        knowledge, planner, contractNet, dispatcher, thinking, owner, clock, story, Journal.none());
  }

  public Ports with(Planner other) {
    return new Ports(
        knowledge,
        other,
        contractNet,
        dispatcher,
        thinking,
        owner,
        clock,
        story,
        journal,
        comeback);
  }

  public Ports with(ActionDispatcher other) {
    return new Ports(
        knowledge, planner, contractNet, other, thinking, owner, clock, story, journal, comeback);
  }

  public Ports with(Story other) {
    return new Ports(
        knowledge,
        planner,
        contractNet,
        dispatcher,
        thinking,
        owner,
        clock,
        other,
        journal,
        comeback);
  }

  /** For work that can wait a moment. */
  public Ports patient() {
    return new Ports(
        knowledge,
        planner,
        contractNet,
        dispatcher,
        thinking.patient(),
        owner,
        clock,
        story,
        journal,
        comeback);
  }
}
