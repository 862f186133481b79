package org.maestro.sim.world;

import org.maestro.hal.Position;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Pose;

/**
 * A lamp as a source of light.
 *
 * @param candela luminous intensity at full level, as stated in the home
 * @param beamDegrees full cone angle
 * @param strength what it gives of the stated light
 */
public record LampLight(
    Pose pose, double candela, double beamDegrees, double strength, double level) {

  public LampLight at(double newLevel) {
    return new LampLight(pose, candela, beamDegrees, strength, newLevel);
  }

  public LampLight weakened(double newStrength) {
    return new LampLight(pose, candela, beamDegrees, newStrength, level);
  }

  /**
   * The third power of the way of its light to a point; metres, 0 when none gets there: outside of
   * the beam, above the lamp or behind a wall.
   */
  double cubedWay(Position point, FloorPlan plan) {
    if (pose.z() <= point.z()
        || pose.angleTo(point.x(), point.y(), point.z()) > beamDegrees / 2
        || plan.isBlocked(pose.floor(), point.floor())) {
      return 0;
    }
    return Math.pow(point.distance(new Position(pose.x(), pose.y(), pose.z())), 3);
  }

  /** What it adds to the light on a horizontal surface: I cos / d^2; lux. */
  public double lux(Position point, double cubedWay) {
    if (level == 0 || cubedWay == 0) {
      return 0;
    }
    double height = pose.z() - point.z();
    return level * strength * candela * height / cubedWay;
  }

  /** The same for a point of which the way is not known yet. */
  public double lux(Position point, FloorPlan plan) {
    return level == 0 ? 0 : lux(point, cubedWay(point, plan));
  }
}
