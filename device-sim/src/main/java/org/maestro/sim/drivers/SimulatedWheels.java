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
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Drive;
import org.maestro.sim.world.Lookout;
import org.maestro.sim.world.World;

/**
 * Wheels on the floor: what they turn, less what they slip, moves the body. Between two commands it
 * goes straight in the direction that it had at the first. Localization is exact (assumed).
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
  private Twist motion = Twist.STILL;
  private Duration since = Duration.ZERO;
  private double headingThen;

  SimulatedWheels(Actuator actuator, WheelGeometry geometry, double slip, double radius) {
    this.actuator = actuator;
    this.geometry = geometry;
    this.slip = slip;
    this.lookout = new Lookout(actuator.world(), actuator.device(), radius);
  }

  @Override
  public void spin(List<Double> radiansPerSecond) {
    boolean moved = !motion.equals(Twist.STILL);
    double heading = heading();
    World world = actuator.world();
    world.whereabouts().stop(actuator.device());
    since = actuator.clock().now();
    headingThen = heading;
    boolean turns = radiansPerSecond.stream().anyMatch(speed -> speed != 0);
    if (!turns || !world.isAlive(actuator.device()) || fault().isPresent()) {
      motion = Twist.STILL;
      if (moved) {
        actuator.tell(WorldEvent.Kind.DRIVEN);
      }
      return;
    }
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
      Point2 from = position();
      Point2 end = new Point2(from.x() + x * WATCHDOG_SECONDS, from.y() + y * WATCHDOG_SECONDS);
      actuator
          .world()
          .whereabouts()
          .start(actuator.device(), new Drive(since, from, List.of(end), speed));
    }
  }

  @Override
  public Point2 position() {
    return actuator.world().position(actuator.device()).orElseThrow().floor();
  }

  @Override
  public double heading() {
    double seconds = actuator.clock().now().minus(since).toNanos() / NANOS;
    return headingThen + motion.turn() * Math.min(seconds, WATCHDOG_SECONDS);
  }

  @Override
  public boolean isFree(Segment ahead) {
    return lookout.isFree(List.of(ahead), LOOK_AHEAD_SECONDS);
  }
}
