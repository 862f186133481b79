package org.maestro.platform;

/**
 * A line of the list of agents: an agent and the RATS member behind it.
 *
 * @param phase of the member on the bus, {@code absent} when it never came
 * @param state the member's current state z
 */
public record AgentRow(String agent, String container, String phase, String state) {}
