package org.maestro.coordination.api;

import java.time.Duration;
import java.util.List;
import java.util.OptionalDouble;
import org.maestro.planning.api.PlanningResult.Obstacle;

/**
 * The record of a search that found nothing: everywhere it was looked, and where not, and why.
 *
 * @param predicate the functional predicate whose value was sought, such as {@code in}
 * @param thing what was sought
 * @param looks in vain, the latest at each place, oldest first
 * @param gaps places at which it may be still, for all that anybody knows
 */
public record SearchReport(String predicate, String thing, List<Look> looks, List<Gap> gaps) {
  public SearchReport {
    looks = List.copyOf(looks);
    gaps = List.copyOf(gaps);
  }

  /**
   * A look that found nothing.
   *
   * @param at simulated time since the platform's start
   * @param coveredShare the share of the place's floor that was looked at, 0 to 1, where it is
   *     known
   */
  public record Look(String place, String by, Duration at, OptionalDouble coveredShare) {}

  /** Why nobody looked at a place, or has to look again. */
  public enum Reason {
    /** No device that there is could ever look there. */
    NOBODY_CAN,
    /** Those who could look there are not here. */
    MEMBERS_LOST,
    /** Something has to be so for a look, and nobody can bring it about. */
    CONDITION,
    /** Looks that were made did not settle it, and are not repeated for ever. */
    LOOKED_IN_VAIN,
    /** A look would be possible, but the goal is out of reach for another reason. */
    OF_NO_USE,
    /** Whether a look would be possible was too much to be planned. */
    NOT_DECIDED
  }

  /**
   * A place that is open still.
   *
   * @param obstacles what stands in the way of a look, for {@code CONDITION} and {@code
   *     MEMBERS_LOST}
   */
  public record Gap(String place, Reason reason, List<Obstacle> obstacles) {
    public Gap {
      obstacles = List.copyOf(obstacles);
    }
  }
}
