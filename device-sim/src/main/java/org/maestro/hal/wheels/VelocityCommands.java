package org.maestro.hal.wheels;

import java.util.List;
import java.util.function.Consumer;
import org.maestro.hal.Twist;

/**
 * The wheels of a base that takes velocities instead of wheel speeds: what wheel speeds make of its
 * motion is told, and a second later that it is to stand still, unless it has been told otherwise
 * meanwhile. Clock thread only.
 */
public final class VelocityCommands {

  /** As {@link org.maestro.hal.WheelMotors} says. */
  private static final double WATCHDOG_SECONDS = 1;

  private final WheelGeometry geometry;
  private final WheeledBase.Pace pace;
  private final Consumer<Twist> base;
  private long commands;

  /**
   * @param base told each velocity
   */
  public VelocityCommands(WheelGeometry geometry, WheeledBase.Pace pace, Consumer<Twist> base) {
    this.geometry = geometry;
    this.pace = pace;
    this.base = base;
  }

  /** See {@link org.maestro.hal.WheelMotors#spin}. */
  public void spin(List<Double> radiansPerSecond) {
    long number = ++commands;
    Twist motion = geometry.motion(radiansPerSecond);
    base.accept(motion);
    if (!motion.equals(Twist.STILL)) {
      pace.after(WATCHDOG_SECONDS, () -> standStillUnlessToldSince(number));
    }
  }

  private void standStillUnlessToldSince(long number) {
    if (number == commands) {
      base.accept(Twist.STILL);
    }
  }
}
