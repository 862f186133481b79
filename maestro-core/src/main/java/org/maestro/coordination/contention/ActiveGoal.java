package org.maestro.coordination.contention;

import java.util.List;
import java.util.Optional;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Takeover;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.recovery.FormerCalls;
import org.maestro.coordination.story.Decisions;
import org.maestro.coordination.story.PlanRecords;
import org.maestro.coordination.worth.Progress;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Change;
import org.maestro.sl.Formula;

/**
 * A goal on its way, to be reached once or to be held, and how others beside it see it. The
 * coordinator's thread only.
 */
public interface ActiveGoal extends Progress, Contender {

  void start();

  /**
   * It is one that a coordinator before this one has begun; nothing is done for it yet.
   *
   * @param awaited what it waits for, for people
   */
  void prepareToTakeUp(Recovery.UnfinishedGoal goal, String awaited);

  /** What was under way is asked for again; after its end, or at once, it is planned anew. */
  void takeUp(Recovery.UnfinishedGoal goal, FormerCalls former);

  GoalStatus status();

  /** The plans that were adopted lately to bring it about, with all that they were chosen from. */
  Decisions decisions();

  /** The latest plans, and what became of their steps. */
  PlanRecords plans();

  void cancel(String who);

  /** The time by which it had to be reached is over. */
  void deadlinePassed();

  /**
   * Something changed that no step of this goal reported.
   *
   * @param changed which facts
   */
  void knowledgeChanged(KnowledgeBase.Change change, FactFilter changed);

  /** A member came, or came back. */
  default void memberPresent(String member) {
    // What is wanted of it will be seen when it is planned again.
  }

  void memberLost(String member);

  /** Somebody could do better what a member is at for this goal. */
  default void offered(Takeover offer) {
    // Whoever has nothing under way has nothing to hand over.
  }

  /** The member gives back what it is at, and will report that it has failed. */
  default void givenBack(String member, String feature, String reason) {
    // Whoever has nothing under way gets nothing back.
  }

  /** It is certain whether a member that was in doubt is there. */
  default void doubtOver(String member) {
    // Only who waits for it has anything to do.
  }

  /** What is to be kept so is so now. */
  boolean isHolding();

  /** What the other's changes would spoil that this goal counts on, if anything. */
  Optional<Formula> countsOn(List<Change> changes, Snapshot now, String other);

  /** It rests until the other is over. */
  void standBackFor(String other);
}
