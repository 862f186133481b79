package org.maestro.hal.wheels;

import java.util.List;
import org.maestro.hal.Twist;

/**
 * Four driven wheels that do not steer and slide sideways in turns: front left, front right, rear
 * left, rear right. Those of one side turn alike, so that it drives as two wheels do that are
 * farther apart.
 *
 * @param radius of a wheel; metres
 * @param halfTrack from the middle sideways to where a wheel would be that turns it as fast without
 *     sliding; metres
 */
public record SkidSteeredWheels(double radius, double halfTrack) implements WheelGeometry {

  private DifferentialWheels sides() {
    return new DifferentialWheels(radius, halfTrack);
  }

  @Override
  public List<Double> wheelSpeeds(Twist motion) {
    List<Double> sides = sides().wheelSpeeds(motion);
    return List.of(sides.get(0), sides.get(1), sides.get(0), sides.get(1));
  }

  @Override
  public Twist motion(List<Double> wheelSpeeds) {
    return sides()
        .motion(
            List.of(
                (wheelSpeeds.get(0) + wheelSpeeds.get(2)) / 2,
                (wheelSpeeds.get(1) + wheelSpeeds.get(3)) / 2));
  }

  @Override
  public boolean isOmnidirectional() {
    return false;
  }
}
