package org.maestro.junit;

import org.assertj.core.api.AbstractAssert;
import org.maestro.sim.world.World;

/** Assertions on the simulated truth, whatever the platform believes. */
public final class WorldAssert extends AbstractAssert<WorldAssert, World> {

  WorldAssert(World actual) {
    super(actual, WorldAssert.class);
  }

  /** Both stand within arm's reach of each other, in nobody's hand. */
  public WorldAssert hasNextTo(String first, String second) {
    return require(
        actual.isNextTo(first, second),
        first
            + " next to "
            + second
            + ", but "
            + whereabouts(first)
            + " and "
            + whereabouts(second));
  }

  public WorldAssert hasApart(String first, String second) {
    return require(
        !actual.isNextTo(first, second),
        first
            + " away from "
            + second
            + ", but "
            + whereabouts(first)
            + " and "
            + whereabouts(second));
  }

  public WorldAssert hasInZone(String thing, String zone) {
    return require(
        actual.zone(thing).filter(zone::equals).isPresent(),
        thing + " in " + zone + ", but " + whereabouts(thing));
  }

  public WorldAssert hasInHandOf(String robot, String thing) {
    return require(
        actual.holder(thing).filter(robot::equals).isPresent(),
        thing + " in the hand of " + robot + ", but " + whereabouts(thing));
  }

  /** Nobody holds it. */
  public WorldAssert hasPutDown(String thing) {
    return require(actual.holder(thing).isEmpty(), thing + " put down, but " + whereabouts(thing));
  }

  /** It is in a container, where nobody sees it. */
  public WorldAssert hasPutAway(String thing) {
    return require(
        actual.holder(thing).isEmpty() && actual.isHidden(thing),
        thing + " put away, but " + whereabouts(thing));
  }

  /** It stands in the open, in nobody's hand. */
  public WorldAssert hasInSight(String thing) {
    return require(
        actual.holder(thing).isEmpty() && !actual.isHidden(thing),
        thing + " in sight, but " + whereabouts(thing));
  }

  /** Light at the zone's reference point. */
  public WorldAssert hasLuxAtLeast(String zone, double lux) {
    return require(
        actual.lux(zone) >= lux,
        "at least " + lux + " lux in " + zone + ", but there are " + actual.lux(zone));
  }

  public WorldAssert hasLampAt(String lamp, double level) {
    return require(
        Math.abs(actual.lampLevel(lamp) - level) < 1e-9,
        lamp + " at level " + level + ", but it is at " + actual.lampLevel(lamp));
  }

  private String whereabouts(String thing) {
    return thing
        + " is "
        + actual
            .holder(thing)
            .map(holder -> "held by " + holder)
            .or(() -> actual.position(thing).map(place -> "at " + place))
            .orElse("nowhere");
  }

  private WorldAssert require(boolean condition, String expectation) {
    isNotNull();
    if (!condition) {
      failWithMessage("Expected the world to have %s.", expectation);
    }
    return this;
  }
}
