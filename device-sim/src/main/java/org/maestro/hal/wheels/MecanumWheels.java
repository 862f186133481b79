package org.maestro.hal.wheels;

import java.util.List;
import org.maestro.hal.Twist;

/**
 * Four Mecanum wheels, their rollers at 45 degrees so that those on the floor point to the middle:
 * front left, front right, rear left, rear right. After Muir and Neuman, "Kinematic modeling for
 * feedback control of an omnidirectional wheeled mobile robot" (1987).
 *
 * @param radius of a wheel; metres
 * @param halfLength from the middle forward to the front axle; metres
 * @param halfWidth from the middle sideways to a wheel; metres
 */
public record MecanumWheels(double radius, double halfLength, double halfWidth)
    implements WheelGeometry {

  private static final int WHEELS = 4;

  @Override
  public List<Double> wheelSpeeds(Twist motion) {
    double turn = motion.turn() * (halfLength + halfWidth);
    return List.of(
        (motion.forward() - motion.left() - turn) / radius,
        (motion.forward() + motion.left() + turn) / radius,
        (motion.forward() + motion.left() - turn) / radius,
        (motion.forward() - motion.left() + turn) / radius);
  }

  /** The least-squares solution: four wheels have one freedom more than the floor. */
  @Override
  public Twist motion(List<Double> wheelSpeeds) {
    double frontLeft = wheelSpeeds.get(0);
    double frontRight = wheelSpeeds.get(1);
    double rearLeft = wheelSpeeds.get(2);
    double rearRight = wheelSpeeds.get(3);
    double share = radius / WHEELS;
    return new Twist(
        share * (frontLeft + frontRight + rearLeft + rearRight),
        share * (-frontLeft + frontRight + rearLeft - rearRight),
        share * (-frontLeft + frontRight - rearLeft + rearRight) / (halfLength + halfWidth));
  }

  @Override
  public boolean isOmnidirectional() {
    return true;
  }
}
