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
    Duration comeback,
    Messenger messenger) {

  /** Twice the time in which members are to be back once their broker is. */
  public static final Duration USUAL_COMEBACK = Duration.ofSeconds(10);

  /** Of a coordinator that speaks to nobody but its members. */
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
        USUAL_COMEBACK,
        Messenger.nobody());
  }

  /** Of one that keeps no journal either. */
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

  public Ports with(KnowledgeBase other) {
    return with(other, planner, dispatcher, thinking, story, messenger);
  }

  public Ports with(Planner other) {
    return with(knowledge, other, dispatcher, thinking, story, messenger);
  }

  public Ports with(ActionDispatcher other) {
    return with(knowledge, planner, other, thinking, story, messenger);
  }

  /** The same in another world: what is known, who bids and who is ordered. */
  public Ports with(KnowledgeBase known, ContractNet bidders, ActionDispatcher crew) {
    return new Ports(
        known, planner, bidders, crew, thinking, owner, clock, story, journal, comeback, messenger);
  }

  public Ports with(Story other) {
    return with(knowledge, planner, dispatcher, thinking, other, messenger);
  }

  public Ports with(Messenger other) {
    return with(knowledge, planner, dispatcher, thinking, story, other);
  }

  /** The same, written down elsewhere. */
  public Ports with(Journal other) {
    return new Ports(
        knowledge,
        planner,
        contractNet,
        dispatcher,
        thinking,
        owner,
        clock,
        story,
        other,
        comeback,
        messenger);
  }

  /** For work that can wait a moment. */
  public Ports patient() {
    return with(knowledge, planner, dispatcher, thinking.patient(), story, messenger);
  }

  private Ports with(
      KnowledgeBase known,
      Planner planning,
      ActionDispatcher orders,
      Thinking thoughts,
      Story told,
      Messenger spoken) {
    return new Ports(
        known,
        planning,
        contractNet,
        orders,
        thoughts,
        owner,
        clock,
        told,
        journal,
        comeback,
        spoken);
  }
}
