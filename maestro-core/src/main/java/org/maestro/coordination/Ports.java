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
    Story story) {}
