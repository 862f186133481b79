package org.maestro.coordination.undoing;

import java.util.List;
import java.util.Optional;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Former;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.Latest;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.sl.Formula;

/**
 * What was so before the steps of goals changed it, of the latest goals that changed anything. A
 * restart forgets it. The coordinator's thread only.
 */
public final class FormerFacts {
  private static final long MOST_BYTES = 512 << 10;

  private final KnowledgeBase knowledge;
  private final Latest<FormerOfGoal> byGoal = new Latest<>(MOST_BYTES, FormerOfGoal::bytes);

  public FormerFacts(KnowledgeBase knowledge) {
    this.knowledge = knowledge;
  }

  /** The order is about to be sent; one that names its call was sent before a restart. */
  public void begun(ActionDispatcher.Request order) {
    FormerOfGoal former = of(order).orElseGet(() -> new FormerOfGoal(knowledge.home()));
    byGoal.remove(id(order));
    former.begun(order.step(), knowledge.snapshot(), order.call().isEmpty());
    byGoal.put(id(order), former);
  }

  /** Its member has answered, or will not any more. */
  public void ended(ActionDispatcher.Request order) {
    of(order).map(FormerOfGoal::ended).orElse(List.of()).forEach(Runnable::run);
  }

  /** Runs the action when nothing that was begun for the goal is under way any more. */
  public void whenAtRest(String goalId, Runnable then) {
    Optional<FormerOfGoal> former = byGoal.find(goalId).filter(FormerOfGoal::isUnderWay);
    former.ifPresentOrElse(goal -> goal.await(then), then);
  }

  /**
   * What was so before it.
   *
   * @param goal for which it was changed: where those are who changed something for it is of no
   *     matter, unless it speaks of them
   * @param others what is wanted now: of what these speak nothing is to be as it was
   */
  public Former before(String goalId, Formula goal, List<Formula> others) {
    return byGoal.find(goalId).map(former -> former.before(goal, others)).orElse(Former.NOTHING);
  }

  private Optional<FormerOfGoal> of(ActionDispatcher.Request order) {
    return byGoal.find(id(order));
  }

  private static String id(ActionDispatcher.Request order) {
    return GoalId.whole(order.goalId());
  }
}
