package org.maestro.agents.goals;

import java.time.Duration;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.planning.api.Planner;

/**
 * The services that an agent needs to pursue goals itself.
 *
 * @param decisionTime simulated time that a decision takes; zero on a paced clock
 */
public record ReasoningServices(KnowledgeBase knowledge, Planner planner, Duration decisionTime) {}
