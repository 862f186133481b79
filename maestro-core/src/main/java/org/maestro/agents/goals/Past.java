package org.maestro.agents.goals;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.StoryEntry;

/**
 * The history from which a coordinator goes on.
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

  /**
   * The past of an agent with goals of its own, which shares the journal with the central one.
   * Which members are there is written down by the central agent alone.
   *
   * @param prefix of its goals' ids
   */
  public Past of(String prefix) {
    return new Past(new GoalsOnly(journal), recovery.of(prefix).withoutMembers(), Map.of());
  }

  /** Of the central agent, whose goals have {@code G} before their number. */
  public Past ofCentre() {
    return new Past(journal, recovery.of(GoalId.CENTRAL), stories, returns);
  }

  private record GoalsOnly(Journal journal) implements Journal {
    @Override
    public void write(JournalEntry entry) {
      if (entry instanceof JournalEntry.OfGoal) {
        journal.write(entry);
      }
    }

    @Override
    public void afterwards(Runnable action) {
      journal.afterwards(action);
    }

    @Override
    public void accept(JournalEntry.Submitted goal, Runnable accepted, Consumer<String> refused) {
      journal.accept(goal, accepted, refused);
    }
  }
}
