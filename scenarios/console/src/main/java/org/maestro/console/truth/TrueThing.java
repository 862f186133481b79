package org.maestro.console.truth;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * A thing as it truly is.
 *
 * @param at where it is; empty of what has no place of its own, and of what is nowhere
 * @param holder who holds it
 * @param level of a lamp, 0 to 1
 * @param open of a door
 */
public record TrueThing(
    String name,
    Optional<Spot> at,
    Optional<String> holder,
    OptionalDouble level,
    Optional<Boolean> open) {

  /** A point of the floor; metres. */
  public record Spot(double x, double y) {}
}
