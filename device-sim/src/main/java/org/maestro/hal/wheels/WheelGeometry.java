package org.maestro.hal.wheels;

import java.util.List;
import org.maestro.hal.Twist;

/**
 * The kinematics of a base: how its wheels are placed, and so what their speeds make of its motion.
 * Immutable.
 */
public sealed interface WheelGeometry permits MecanumWheels, DifferentialWheels, SkidSteeredWheels {

  /**
   * The speeds that the wheels need for a motion (inverse kinematics); radians a second.
   *
   * @throws IllegalArgumentException when no wheel speeds give such a motion
   */
  List<Double> wheelSpeeds(Twist motion);

  /** The motion that wheel speeds give, evened out where they contradict each other. */
  Twist motion(List<Double> wheelSpeeds);

  /** Whether it drives to the side without turning first. */
  boolean isOmnidirectional();
}
