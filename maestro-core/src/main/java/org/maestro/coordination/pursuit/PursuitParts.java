package org.maestro.coordination.pursuit;

import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.contention.Contention;
import org.maestro.coordination.contention.PlanUnderway;
import org.maestro.coordination.contention.Rivals;
import org.maestro.coordination.contention.StepsUnderway;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalStory;

/**
 * What those share who work at one goal: who plans for it, who follows its plan, and who ends it.
 * The coordinator's thread only.
 */
record PursuitParts(
    Ports ports,
    Roster roster,
    Rivals rivals,
    ExactPrices exactPrices,
    GoalLife life,
    GoalStory story,
    Outlook outlook,
    PlanUnderway plan,
    StepsUnderway underway,
    Contention contention,
    Turn turn) {

  static PursuitParts of(
      GoalLife life,
      GoalStory story,
      Ports ports,
      Roster roster,
      Rivals rivals,
      ExactPrices exactPrices) {
    PlanUnderway plan = new PlanUnderway();
    StepsUnderway underway = new StepsUnderway();
    Contention contention =
        new Contention(life.id(), life.request(), ports, rivals, plan, underway);
    return new PursuitParts(
        ports,
        roster,
        rivals,
        exactPrices,
        life,
        story,
        new Outlook(life.id(), life.request(), ports, rivals),
        plan,
        underway,
        contention,
        new Turn(life, story, rivals, contention, underway));
  }

  String id() {
    return life.id();
  }
}
