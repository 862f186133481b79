package org.maestro.agents;

import java.time.Duration;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.planning.Planner;

/**
 * What an agent needs to pursue goals itself.
 *
 * @param decisionTime simulated time that a decision takes; zero on a paced clock
 */
public record Mind(KnowledgeBase knowledge, Planner planner, Duration decisionTime) {}
