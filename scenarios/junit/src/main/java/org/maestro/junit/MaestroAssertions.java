package org.maestro.junit;

import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.sim.world.World;

/** Entry points to the assertions over goals, world and knowledge. */
public final class MaestroAssertions {

  private MaestroAssertions() {}

  public static GoalOutcomeAssert assertThat(GoalOutcome actual) {
    return new GoalOutcomeAssert(actual);
  }

  public static KnowledgeAssert assertThat(KnowledgeBase actual) {
    return new KnowledgeAssert(actual);
  }

  public static WorldAssert assertThat(World actual) {
    return new WorldAssert(actual);
  }
}
