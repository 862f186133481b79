package org.maestro.coordination;

import org.maestro.knowledge.KnowledgeBase;
import org.maestro.planning.Planner;
import org.maestro.rats.time.Clock;

/** Everything outside that coordination uses. */
public record Ports(
    KnowledgeBase knowledge,
    Planner planner,
    Market market,
    Crew crew,
    Thinking thinking,
    Clock clock,
    Story story,
    Journal journal) {

  /** Of a coordinator that keeps no journal. */
  public Ports(
      KnowledgeBase knowledge,
      Planner planner,
      Market market,
      Crew crew,
      Thinking thinking,
      Clock clock,
      Story story) {
    this(knowledge, planner, market, crew, thinking, clock, story, Journal.none());
  }

  Ports with(Planner other) {
    return new Ports(knowledge, other, market, crew, thinking, clock, story, journal);
  }

  Ports with(Crew other) {
    return new Ports(knowledge, planner, market, other, thinking, clock, story, journal);
  }
}
