package org.maestro.hal.wheels;

import java.util.List;
import org.maestro.hal.Twist;

/**
 * Two driven wheels on one axle, left and right; the rest rolls along.
 *
 * @param radius of a wheel; metres
 * @param halfTrack from the middle sideways to a wheel; metres
 */
public record DifferentialWheels(double radius, double halfTrack) implements WheelGeometry {

  private static final double NOTHING = 1e-9;

  @Override
  public List<Double> wheelSpeeds(Twist motion) {
    if (Math.abs(motion.left()) > NOTHING) {
      throw new IllegalArgumentException(
          "Two wheels cannot drive to the side; turn first instead of %s m/s to the left."
              .formatted(motion.left()));
    }
    double turn = motion.turn() * halfTrack;
    return List.of((motion.forward() - turn) / radius, (motion.forward() + turn) / radius);
  }

  @Override
  public Twist motion(List<Double> wheelSpeeds) {
    double left = wheelSpeeds.get(0);
    double right = wheelSpeeds.get(1);
    return new Twist(radius * (left + right) / 2, 0, radius * (right - left) / (2 * halfTrack));
  }

  @Override
  public boolean isOmnidirectional() {
    return false;
  }
}
