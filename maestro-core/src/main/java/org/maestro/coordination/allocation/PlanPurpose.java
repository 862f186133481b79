package org.maestro.coordination.allocation;

/** Purpose of a plan. A plan to see that the goal is reached is made for a confirmation besides. */
public enum PlanPurpose {
  /** To make the goal so. */
  REACH,

  /** The same, trusting that steps before one that was declined clear its way. */
  REACH_TRUSTING,

  /** Nobody can make it so: to look whether it is so already. */
  FIND_OUT,

  /** To look whether something is where the goal says, and not to put it there. */
  LOOK
}
