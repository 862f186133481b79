package org.maestro.hal.wheels;

import java.util.List;
import java.util.Optional;
import org.maestro.hal.Completion;
import org.maestro.hal.Localization;
import org.maestro.hal.MobileBase;
import org.maestro.hal.Steering;
import org.maestro.hal.Twist;
import org.maestro.hal.WheelMotors;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/**
 * A base that follows a way by its wheels, or turns on the spot: some times a second it looks where
 * it is, aims at the next corner, and gives its wheels the speeds for that; so it makes good for
 * slip. One that cannot drive to the side turns at each corner first. Clock thread only.
 */
public final class WheeledBase implements MobileBase, Steering {

  /** So little left of a turn counts as turned; radians. */
  private static final double TURNED = 1e-3;

  private final WheelGeometry geometry;
  private final WheelMotors motors;
  private final Localization localization;
  private final Pace pace;
  private final Limits limits;
  private long driveNumber;

  /** Goes on after some seconds, if the device has power then. */
  public interface Pace {
    void after(double seconds, Runnable next);
  }

  /**
   * The limits of the base and of its control.
   *
   * @param speed metres a second
   * @param turnSpeed radians a second
   * @param radius of the circle around it; metres
   * @param power watts while driving
   * @param controlSeconds between two commands to the wheels
   * @param delaySeconds from a command to when what comes of it is seen; what is seen later than
   *     its next command would make it swing about where it aims
   * @param nearMetres so near to a corner it counts as reached
   * @param aimRadians so well aimed, it need not turn more
   */
  public record Limits(
      double speed,
      double turnSpeed,
      double radius,
      double power,
      double controlSeconds,
      double delaySeconds,
      double nearMetres,
      double aimRadians) {}

  public WheeledBase(
      WheelGeometry geometry,
      WheelMotors motors,
      Localization localization,
      Pace pace,
      Limits limits) {
    this.geometry = geometry;
    this.motors = motors;
    this.localization = localization;
    this.pace = pace;
    this.limits = limits;
  }

  @Override
  public void drive(List<Point2> way, Completion completion) {
    stop();
    long number = driveNumber;
    pace.after(0, () -> goOn(List.copyOf(way), 0, number, completion));
  }

  private void goOn(List<Point2> way, int passed, long number, Completion completion) {
    if (number != driveNumber) {
      return;
    }
    Optional<String> fault = motors.fault();
    if (fault.isPresent()) {
      stop();
      completion.failed(fault.get());
      return;
    }
    Point2 here = localization.position();
    int next = passed;
    while (next < way.size() && here.distance(way.get(next)) <= limits.nearMetres()) {
      next++;
    }
    if (next == way.size()) {
      stop();
      completion.done();
      return;
    }
    Point2 corner = way.get(next);
    double distance = here.distance(corner);
    double ahead = Math.min(distance, limits.speed() * limits.controlSeconds());
    Point2 reached = new Segment(here, corner).at(ahead / distance);
    if (!localization.isFree(new Segment(here, reached))) {
      stop();
      completion.failed("something stands in the way");
      return;
    }
    int from = next;
    double seconds = step(here, corner, distance);
    pace.after(seconds, () -> goOn(way, from, number, completion));
  }

  /** One command to the wheels; returns for how long. */
  private double step(Point2 here, Point2 corner, double distance) {
    double direction = Math.atan2(corner.y() - here.y(), corner.x() - here.x());
    double off = Math.IEEEremainder(direction - localization.heading(), 2 * Math.PI);
    if (!geometry.isOmnidirectional() && Math.abs(off) > limits.aimRadians()) {
      double turnSpeed = slowing(limits.turnSpeed(), Math.abs(off));
      motors.spin(geometry.wheelSpeeds(new Twist(0, 0, Math.signum(off) * turnSpeed)));
      return Math.min(limits.controlSeconds(), Math.abs(off) / turnSpeed);
    }
    double speed = slowing(limits.speed(), distance);
    motors.spin(
        geometry.wheelSpeeds(
            geometry.isOmnidirectional()
                ? new Twist(speed * Math.cos(off), speed * Math.sin(off), 0)
                : new Twist(speed, 0, off / seenWithin())));
    return Math.min(limits.controlSeconds(), distance / speed);
  }

  /** The speed with so much left, such that what is seen late does not take it far beyond. */
  private double slowing(double speed, double left) {
    return Math.min(speed, left / (2 * limits.delaySeconds()));
  }

  /** From a command to the next that knows what came of it; seconds. */
  private double seenWithin() {
    return limits.controlSeconds() + limits.delaySeconds();
  }

  @Override
  public void turn(double radians, Completion completion) {
    stop();
    long number = driveNumber;
    pace.after(0, () -> turnOn(new Turning(radians, localization.heading(), number), completion));
  }

  /**
   * A turn under way.
   *
   * @param left of it, as far as was known at the last look; radians
   * @param seen the heading at that look
   */
  private record Turning(double left, double seen, long number) {

    /** The same at the next look, within which it has turned by less than half of a circle. */
    Turning at(double heading) {
      return new Turning(left - Math.IEEEremainder(heading - seen, 2 * Math.PI), heading, number);
    }
  }

  private void turnOn(Turning before, Completion completion) {
    if (before.number() != driveNumber) {
      return;
    }
    Optional<String> fault = motors.fault();
    if (fault.isPresent()) {
      stop();
      completion.failed(fault.get());
      return;
    }
    Turning now = before.at(localization.heading());
    if (Math.abs(now.left()) <= TURNED) {
      stop();
      completion.done();
      return;
    }
    // Slower at its end, so that a command that comes late turns it too far by little.
    double speed = Math.min(limits.turnSpeed(), Math.abs(now.left()) / seenWithin());
    motors.spin(geometry.wheelSpeeds(new Twist(0, 0, Math.signum(now.left()) * speed)));
    pace.after(limits.controlSeconds(), () -> turnOn(now, completion));
  }

  @Override
  public double heading() {
    return localization.heading();
  }

  @Override
  public double turnSpeed() {
    return limits.turnSpeed();
  }

  @Override
  public void stop() {
    driveNumber++;
    motors.spin(geometry.wheelSpeeds(Twist.STILL));
  }

  @Override
  public Point2 position() {
    return localization.position();
  }

  @Override
  public double speed() {
    return limits.speed();
  }

  @Override
  public double radius() {
    return limits.radius();
  }

  @Override
  public double power() {
    return limits.power();
  }
}
