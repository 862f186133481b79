package org.maestro.agents.supervision;

import java.util.List;
import org.maestro.deployment.AgentStart;

/** Agents that a container which joined is to begin, and that are asked to move there. */
public record Welcome(List<AgentStart> begun, List<String> toMove) {}
