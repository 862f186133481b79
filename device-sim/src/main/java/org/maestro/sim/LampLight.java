package org.maestro.sim;

import org.maestro.hal.Position;
import org.maestro.ontology.home.FloorPlan;
import org.maestro.ontology.home.Pose;

/**
 * A lamp as a source of light.
 *
 * @param candela luminous intensity at full level, as stated in the home
 * @param beamDegrees full cone angle
 * @param strength what it gives of the stated light
 */
record LampLight(Pose pose, double candela, double beamDegrees, double strength, double level) {

  LampLight at(double newLevel) {
    return new LampLight(pose, candela, beamDegrees, strength, newLevel);
  }

  LampLight weakened(double newStrength) {
    return new LampLight(pose, candela, beamDegrees, newStrength, level);
  }

  /**
   * What it adds to the light on a horizontal surface: I cos / d^2, nothing outside the beam or
   * behind a wall; lux.
   */
  double lux(Position point, FloorPlan plan) {
    double height = pose.z() - point.z();
    if (level == 0
        || height <= 0
        || pose.angleTo(point.x(), point.y(), point.z()) > beamDegrees / 2
        || plan.isBlocked(pose.floor(), point.floor())) {
      return 0;
    }
    double distance = point.distance(new Position(pose.x(), pose.y(), pose.z()));
    return level * strength * candela * height / Math.pow(distance, 3);
  }
}
