package org.maestro.coordination.achievement;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.api.ContractNet;
import org.maestro.planning.api.Plan;
import org.maestro.sl.Term;

/** The transitions of a goal, as those who work at its parts ask for them. */
interface GoalTransitions {

  /**
   * A plan from the present; when one is being made already, after it.
   *
   * @param why it is not the first
   */
  void makePlan(Optional<String> why);

  boolean isPlanning();

  /** It is made again as soon as the plan that is being made is there. */
  void makePlanAgain(String why);

  /** The plan is the right one; those who made their prices for it are told. */
  void adopt(Plan found, ContractNet.Round tender);

  void noPlan(PlanningRound.Ended round);

  /** So often nobody could see it that nobody is asked again. */
  void noPlanToSeeIt();

  /** Begins what may begin. */
  void advance();

  /** The goal holds by what is known: end, or have it seen first. */
  void settle(Map<String, Term> binding);

  void giveUp(List<String> reasons);
}
