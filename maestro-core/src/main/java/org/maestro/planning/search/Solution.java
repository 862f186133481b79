package org.maestro.planning.search;

import java.util.List;
import org.maestro.planning.ground.GroundOperator;

/**
 * The knowledge of a planner at one moment: its best plan so far, and a bound.
 *
 * @param operators the best plan so far; empty unless {@link #hasPlan}
 * @param cost of that plan, in units of the task
 * @param lowerBound no plan costs less, proven; in units of the task
 * @param memoryUsedUp a search ended because the memory that was allowed did not suffice for more
 */
public record Solution(
    Verdict verdict,
    List<GroundOperator> operators,
    long cost,
    long lowerBound,
    boolean memoryUsedUp) {
  public Solution {
    operators = List.copyOf(operators);
  }

  /** The verdict of a planner: how far it came. */
  public enum Verdict {
    /** No plan is cheaper: proven. */
    OPTIMAL,
    /** There is a plan; whether a cheaper one exists is open. */
    PLAN,
    /** There is no plan: proven. */
    UNSOLVABLE,
    /** No plan was found before time was over. */
    OUT_OF_TIME,
    /** No plan was found in the memory that was allowed. */
    OUT_OF_MEMORY
  }

  public boolean hasPlan() {
    return verdict == Verdict.OPTIMAL || verdict == Verdict.PLAN;
  }

  static Solution without(Verdict verdict, long lowerBound) {
    return new Solution(verdict, List.of(), 0, lowerBound, verdict == Verdict.OUT_OF_MEMORY);
  }

  /** The same in units that are smaller. */
  Solution times(long factor) {
    return factor == 1
        ? this
        : new Solution(verdict, operators, cost * factor, lowerBound * factor, memoryUsedUp);
  }

  Solution afterMemoryWasUsedUp() {
    return hasPlan()
        ? new Solution(verdict, operators, cost, lowerBound, true)
        : without(Verdict.OUT_OF_MEMORY, lowerBound);
  }
}
