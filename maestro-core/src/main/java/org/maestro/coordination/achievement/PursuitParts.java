package org.maestro.coordination.achievement;

import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.allocation.PlanPurpose;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.contention.PlanUnderway;
import org.maestro.coordination.contention.ResourceClaims;
import org.maestro.coordination.contention.StepsUnderway;
import org.maestro.coordination.lessons.VainDeeds;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalStory;

/**
 * The parts shared by those who work at one goal: who plans for it, who follows its plan, and who
 * ends it. The coordinator's thread only.
 */
record PursuitParts(
    Ports ports,
    Roster roster,
    ActiveGoals activeGoals,
    ExactPrices exactPrices,
    GoalLife life,
    GoalStory story,
    GoalMonitor monitor,
    PlanUnderway plan,
    StepsUnderway underway,
    ResourceClaims resourceClaims,
    Preemption preemption) {

  static PursuitParts of(
      GoalLife life,
      GoalStory story,
      Ports ports,
      Roster roster,
      ActiveGoals activeGoals,
      ExactPrices exactPrices,
      VainDeeds deeds,
      PlanPurpose purpose) {
    PlanUnderway plan = new PlanUnderway();
    StepsUnderway underway = new StepsUnderway();
    ResourceClaims resourceClaims =
        new ResourceClaims(life.id(), life.request(), ports, activeGoals, plan, underway);
    return new PursuitParts(
        ports,
        roster,
        activeGoals,
        exactPrices,
        life,
        story,
        new GoalMonitor(life.id(), life.request(), ports, activeGoals, deeds, purpose),
        plan,
        underway,
        resourceClaims,
        new Preemption(life, story, activeGoals, resourceClaims, underway));
  }

  String id() {
    return life.id();
  }
}
