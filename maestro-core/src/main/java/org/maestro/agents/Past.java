package org.maestro.agents;

import java.util.List;
import java.util.Map;
import org.maestro.coordination.Journal;
import org.maestro.coordination.Recovery;
import org.maestro.coordination.StoryEntry;

/**
 * What a coordinator goes on from.
 *
 * @param journal where it writes down what it does; its actions may run on any thread
 * @param recovery what was found there
 * @param stories what was told of goals before, by their ids
 * @param returns another coordinator was there before it on this platform: the agents are asked who
 *     is there
 */
public record Past(
    Journal journal, Recovery recovery, Map<String, List<StoryEntry>> stories, boolean returns) {

  /** Of the first coordinator of a platform. */
  public Past(Journal journal, Recovery recovery, Map<String, List<StoryEntry>> stories) {
    this(journal, recovery, stories, false);
  }

  /** Nothing was before, and nothing is kept. */
  public static Past none() {
    return new Past(Journal.none(), Recovery.NOTHING, Map.of());
  }
}
