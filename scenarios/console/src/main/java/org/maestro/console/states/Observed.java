package org.maestro.console.states;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.pulse.HeartbeatSettings;
import org.maestro.rats.protocol.MemberStatus;

/**
 * What was observed of a platform at one time.
 *
 * @param bus why the bus cannot be reached; empty when it can
 * @param journal why nothing can be written down; empty when it can
 * @param keepsJournal whether there is a journal
 * @param containers that are there
 * @param gone containers of other processes that were there and are not any more
 * @param agents that are there or should be
 * @param idle agents that do nothing though their containers live
 * @param phases of members on the bus
 * @param refused members that describe themselves wrongly, and why
 * @param homeless members whose agents fit on no host that is there
 */
record Observed(
    Optional<String> bus,
    Optional<String> journal,
    boolean keepsJournal,
    HeartbeatSettings timing,
    List<Container> containers,
    List<Container> gone,
    List<Agent> agents,
    Map<String, Condition> idle,
    Map<String, MemberStatus.Phase> phases,
    Map<String, String> refused,
    Set<String> homeless) {

  /**
   * A container.
   *
   * @param process in which it lives, in words
   * @param isOwn whether that is the platform's own
   * @param silence since its last sign of life
   */
  record Container(
      String name,
      String process,
      boolean isOwn,
      Condition condition,
      Duration silence,
      List<String> agents) {}

  /**
   * An agent.
   *
   * @param members that it stands for
   * @param isThere whether JADE has it
   */
  record Agent(String name, String container, List<String> members, boolean isThere) {}
}
