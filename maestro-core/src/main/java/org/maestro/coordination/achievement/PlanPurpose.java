package org.maestro.coordination.achievement;

/** Purpose of a plan. A plan to see that the goal is reached is made for a confirmation besides. */
enum PlanPurpose {
  /** To make the goal so. */
  REACH,

  /** The same, trusting that steps before one that was declined clear its way. */
  REACH_TRUSTING,

  /** Nobody can make it so: to look whether it is so already. */
  FIND_OUT
}
