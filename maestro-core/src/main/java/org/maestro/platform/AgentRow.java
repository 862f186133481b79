package org.maestro.platform;

import java.time.Instant;
import java.util.List;

/**
 * A line of the list of agents: an agent and the RATS members behind it.
 *
 * @param members that it stands for; none of a group agent
 * @param phase of the member on the bus, {@code absent} when it never came, {@code group} of an
 *     agent that stands for a group; of several members the one that most have
 * @param state the member's current state z
 * @param disabled the features that its member tells as disabled (M33); of several members each
 *     with the member's name and a slash before it
 * @param since when phase and state are these, or the agent lives in this container, whichever is
 *     later
 */
public record AgentRow(
    String agent,
    String container,
    List<String> members,
    String phase,
    String state,
    List<String> disabled,
    Instant since) {
  public AgentRow {
    members = List.copyOf(members);
    disabled = List.copyOf(disabled);
  }
}
