package org.maestro.planning.api;

import java.util.List;
import java.util.OptionalDouble;
import org.maestro.planning.api.PlanningResult.Obstacle;

/**
 * Why a step of a plan was given to its member and not to another.
 *
 * @param cost of the whole plan
 * @param others who could have had a part in it instead, the better one first
 */
public record Choice(Step step, double cost, List<Other> others) {

  /**
   * An alternative: what the plan would be with another member.
   *
   * @param more how much more the plan would cost; empty: with it there is none
   * @param atLeast the price is a lower bound, since nobody asked
   * @param because what stands in its way; empty when there is a plan
   */
  public record Other(
      String member, OptionalDouble more, boolean atLeast, List<Obstacle> because) {}
}
