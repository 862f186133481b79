package org.maestro.planning.api;

/** The criterion by which a plan is to be best: the allocation strategy's choice. */
public enum Objective {
  /** Least sum of costs. */
  CHEAPEST,

  /**
   * Least time from the first step's beginning to the last one's end, with steps side by side where
   * they may be; among plans of equal length the least cost.
   */
  EARLIEST_FINISH
}
