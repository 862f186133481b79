package org.maestro.sim.drivers;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.maestro.hal.Localization;
import org.maestro.hal.Twist;
import org.maestro.hal.WheelMotors;
import org.maestro.hal.wheels.WheelGeometry;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;
import org.maestro.sim.parameters.ScannerData;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Astray;
import org.maestro.sim.world.Drive;
import org.maestro.sim.world.Lookout;
import org.maestro.sim.world.World;

/**
 * Wheels on the floor: what they turn, less what they slip, moves the body. Between two commands it
 * goes straight in the direction that it had at the first. Where it is it reckons by what they were
 * told, so that slip leads it astray, until it matches what its scanner sees with its plan.
 */
final class SimulatedWheels implements WheelMotors, Localization {

  /** As {@link WheelMotors} says. */
  private static final double WATCHDOG_SECONDS = 1;

  /** How far ahead others that move are thought of; assumed. */
  private static final double LOOK_AHEAD_SECONDS = 0.1;

  private static final double NANOS = 1e9;

  private final Actuator actuator;
  private final WheelGeometry geometry;
  private final double slip;
  private final Lookout lookout;
  private final Runnable look;
  private final ScannerData scanner;
  private Twist told = Twist.STILL;
  private Twist motion = Twist.STILL;
  private Duration since = Duration.ZERO;
  private double headingThen;
  private double headingError;

  SimulatedWheels(
      Actuator actuator,
      WheelGeometry geometry,
      double slip,
      double radius,
      ScannerData scanner,
      Runnable look) {
    this.actuator = actuator;
    this.geometry = geometry;
    this.slip = slip;
    this.scanner = scanner;
    this.look = look;
    this.lookout = new Lookout(actuator.world(), actuator.device(), radius);
  }

  @Override
  public void spin(List<Double> radiansPerSecond) {
    boolean moved = !motion.equals(Twist.STILL);
    double heading = trueHeading();
    World world = actuator.world();
    astray(astray());
    headingError = headingErrorNow();
    world.whereabouts().stop(actuator.device());
    since = actuator.clock().now();
    headingThen = heading;
    boolean turns = radiansPerSecond.stream().anyMatch(speed -> speed != 0);
    if (!turns || !world.isAlive(actuator.device()) || fault().isPresent()) {
      told = Twist.STILL;
      motion = Twist.STILL;
      if (moved) {
        actuator.tell(WorldEvent.Kind.DRIVEN);
      }
      return;
    }
    told = geometry.motion(radiansPerSecond);
    double grip = 1 - world.faults().slipOf(actuator.device());
    motion =
        geometry.motion(
            radiansPerSecond.stream()
                .map(speed -> speed * grip * (1 - actuator.error(slip)))
                .toList());
    roll(heading);
    if (!moved) {
      actuator.tell(WorldEvent.Kind.DRIVE);
    }
  }

  @Override
  public Optional<String> fault() {
    return actuator.world().faults().defect(actuator.device());
  }

  private void roll(double heading) {
    double speed = motion.speed();
    if (speed > 0) {
      double x = motion.forward() * Math.cos(heading) - motion.left() * Math.sin(heading);
      double y = motion.forward() * Math.sin(heading) + motion.left() * Math.cos(heading);
      Point2 from = truth();
      Point2 end = new Point2(from.x() + x * WATCHDOG_SECONDS, from.y() + y * WATCHDOG_SECONDS);
      actuator
          .world()
          .whereabouts()
          .start(actuator.device(), new Drive(since, from, List.of(end), speed));
    }
  }

  private Point2 truth() {
    return actuator.world().position(actuator.device()).orElseThrow().floor();
  }

  private double trueHeading() {
    return headingThen + motion.turn() * secondsSince();
  }

  private double secondsSince() {
    double seconds = actuator.clock().now().minus(since).toNanos() / NANOS;
    return Math.min(seconds, WATCHDOG_SECONDS);
  }

  @Override
  public Point2 position() {
    return astray().from(truth());
  }

  @Override
  public double heading() {
    return trueHeading() + headingErrorNow();
  }

  /** What it reckons to have moved since the last command, less what it has moved. */
  private Astray astray() {
    double forward = (told.forward() - motion.forward()) * secondsSince();
    double left = (told.left() - motion.left()) * secondsSince();
    return actuator
        .world()
        .faults()
        .astray(actuator.device())
        .plus(
            forward * Math.cos(headingThen) - left * Math.sin(headingThen),
            forward * Math.sin(headingThen) + left * Math.cos(headingThen));
  }

  private double headingErrorNow() {
    return headingError + (told.turn() - motion.turn()) * secondsSince();
  }

  private void astray(Astray error) {
    actuator.world().faults().lead(actuator.device(), error);
  }

  /** Makes good for a share of what it errs, as far as walls can be seen. */
  private void match() {
    if (motion.equals(told) && headingError == 0 && astray().isNot() || !seesWalls()) {
      return;
    }
    double left = 1 - scanner.matchShare();
    double error = scanner.matchShare() * scanner.matchError();
    astray(
        actuator
            .world()
            .faults()
            .astray(actuator.device())
            .times(left)
            .plus(actuator.error(error), actuator.error(error)));
    headingError =
        left * headingError
            + actuator.error(scanner.matchShare() * Math.toRadians(scanner.matchDegrees()));
  }

  private boolean seesWalls() {
    Point2 here = truth();
    return actuator.world().building().walls().stream()
        .anyMatch(wall -> wall.distance(here) <= scanner.range());
  }

  @Override
  public boolean isFree(Segment ahead) {
    look.run();
    match();
    Astray error = astray();
    Segment truly = new Segment(error.truth(ahead.from()), error.truth(ahead.to()));
    return lookout.isFree(List.of(truly), LOOK_AHEAD_SECONDS);
  }
}
