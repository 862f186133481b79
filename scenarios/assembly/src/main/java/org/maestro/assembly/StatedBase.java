package org.maestro.assembly;

import java.time.Duration;
import java.util.List;
import java.util.function.Predicate;
import org.maestro.hal.Drivers;
import org.maestro.hal.Localization;
import org.maestro.hal.MobileBase;
import org.maestro.hal.Steering;
import org.maestro.hal.Surroundings;
import org.maestro.hal.WheelMotors;
import org.maestro.hal.wheels.DifferentialWheels;
import org.maestro.hal.wheels.MecanumWheels;
import org.maestro.hal.wheels.WheelGeometry;
import org.maestro.hal.wheels.WheeledBase;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.Clock;
import org.maestro.sim.world.FloorMap;
import org.maestro.sl.Term;

/**
 * What a home states of a robot whose base takes velocities, and what it can do with them. It knows
 * the home's walls, doors closed, and sees nothing of what stands on the floor.
 */
final class StatedBase {

  /** Of a robot of which the home states nothing; assumed, such that it does no harm. */
  private static final double USUAL_SPEED = 0.4;

  private static final double USUAL_TURN_DEGREES = 45;
  private static final double USUAL_RADIUS = 0.3;

  /** Watts while driving; assumed, as no server tells it. */
  private static final double POWER = 50;

  /** Of the control: seconds between two commands, and how exactly corners are met; assumed. */
  private static final double CONTROL_SECONDS = 0.1;

  /** From a command to when the server tells what came of it; assumed. */
  private static final double DELAY_SECONDS = 0.1;

  private static final double NEAR_METRES = 0.05;
  private static final double AIM_RADIANS = 0.1;

  private static final double NANOS = 1e9;

  private final Device device;
  private final HomeFloor floor;
  private final Clock clock;

  StatedBase(Home home, Device device, Clock clock) {
    this.device = device;
    this.floor = new HomeFloor(home);
    this.clock = clock;
  }

  /** What it does later it does on the clock. */
  static WheeledBase.Pace pace(Device device, Clock clock) {
    return (seconds, next) ->
        clock.schedule(Duration.ofNanos(Math.round(seconds * NANOS)), device.id(), next);
  }

  WheeledBase.Pace pace() {
    return pace(device, clock);
  }

  Predicate<Segment> isFree() {
    double radius = stated("bodyRadius", USUAL_RADIUS);
    return ahead -> floor.isFree(ahead, radius);
  }

  /** As the base takes velocities, the wheels' measures cancel out. */
  WheelGeometry wheels() {
    boolean drivesToTheSide =
        device
            .individual()
            .properties()
            .getOrDefault("wheels", List.of())
            .contains(new Term.Text("mecanum"));
    return drivesToTheSide ? new MecanumWheels(1, 1, 1) : new DifferentialWheels(1, 1);
  }

  /** Metres a second. */
  double speed() {
    return stated("speed", USUAL_SPEED);
  }

  WheeledBase on(WheelMotors motors, Localization localization) {
    return new WheeledBase(
        wheels(),
        motors,
        localization,
        pace(),
        new WheeledBase.Limits(
            speed(),
            Math.toRadians(stated("turnSpeed", USUAL_TURN_DEGREES)),
            stated("bodyRadius", USUAL_RADIUS),
            POWER,
            CONTROL_SECONDS,
            DELAY_SECONDS,
            NEAR_METRES,
            AIM_RADIANS));
  }

  Drivers drivers(WheeledBase base) {
    return Drivers.none()
        .with(MobileBase.class, base)
        .with(Steering.class, base)
        .with(Surroundings.class, floor);
  }

  private double stated(String property, double otherwise) {
    return FloorMap.number(device.individual(), property).orElse(otherwise);
  }
}
