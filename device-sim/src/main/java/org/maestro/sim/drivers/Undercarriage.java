package org.maestro.sim.drivers;

import java.util.List;
import java.util.Optional;
import org.maestro.hal.MobileBase;
import org.maestro.hal.wheels.DifferentialWheels;
import org.maestro.hal.wheels.MecanumWheels;
import org.maestro.hal.wheels.SkidSteeredWheels;
import org.maestro.hal.wheels.WheelGeometry;
import org.maestro.hal.wheels.WheeledBase;
import org.maestro.ontology.home.Device;
import org.maestro.sim.parameters.BaseData;
import org.maestro.sim.parameters.ScannerData;
import org.maestro.sim.parameters.WheelData;
import org.maestro.sim.world.FloorMap;
import org.maestro.sl.Term;

/**
 * What a robot drives on: the base that its driver names, with the wheels, the size and the speeds
 * that the home states of it (A40), else those of the parameters.
 */
final class Undercarriage {

  /** How wheels are placed, by the words of {@code maestro:wheels}. */
  enum Wheels {
    DIFFERENTIAL("differential"),
    SKID_STEERED("skid-steered"),
    MECANUM("mecanum");

    private final String word;

    Wheels(String word) {
      this.word = word;
    }

    private static Optional<Wheels> of(Device device) {
      return device.individual().properties().getOrDefault("wheels", List.of()).stream()
          .flatMap(
              value ->
                  List.of(values()).stream()
                      .filter(wheels -> new Term.Text(wheels.word).equals(value)))
          .findFirst();
    }
  }

  /** Of a normal distribution, all but a twentieth lies within. */
  private static final double DEVIATIONS = 2;

  private final Device device;
  private final WheelData wheels;
  private final ScannerData scanner;
  private final BaseData base;
  private final Runnable look;

  /**
   * @param base at the speed of this robot
   * @param look to be run as often as it has moved on a little
   */
  Undercarriage(
      Device device, WheelData wheels, ScannerData scanner, BaseData base, Runnable look) {
    this.device = device;
    this.wheels = wheels;
    this.scanner = scanner;
    this.look = look;
    this.base = base.ofRadius(stated("bodyRadius", base.radius()));
  }

  BaseData base() {
    return base;
  }

  /** A base whose wheels nobody looks at: it drives to all sides without turning. */
  MobileBase gliding(Actuator actuator) {
    return Wheels.of(device)
        .map(placed -> onWheels(actuator, placed))
        .orElseGet(() -> new SimulatedBase(actuator, base, wheels.slip(), look));
  }

  /**
   * @param usual how its wheels are placed, unless the home says otherwise
   */
  MobileBase onWheels(Actuator actuator, Wheels usual) {
    WheelGeometry geometry = geometry(Wheels.of(device).orElse(usual));
    SimulatedWheels turning =
        new SimulatedWheels(actuator, geometry, wheels.slip(), base.radius(), scanner, look);
    return new WheeledBase(
        geometry,
        turning,
        turning,
        actuator::after,
        new WheeledBase.Limits(
            base.speed(),
            turnSpeed(),
            base.radius() + room(),
            base.power(),
            wheels.controlSeconds(),
            0,
            wheels.nearMetres(),
            wheels.aimRadians()));
  }

  private WheelGeometry geometry(Wheels placed) {
    double radius = stated("wheelRadius", wheels.wheelRadius());
    double halfTrack = stated("trackWidth", 2 * wheels.halfWidth()) / 2;
    return switch (placed) {
      case DIFFERENTIAL -> new DifferentialWheels(radius, halfTrack);
      case SKID_STEERED -> new SkidSteeredWheels(radius, halfTrack);
      case MECANUM ->
          new MecanumWheels(radius, stated("axleDistance", 2 * wheels.halfLength()) / 2, halfTrack);
    };
  }

  private double turnSpeed() {
    return Math.toRadians(stated("turnSpeed", Math.toDegrees(wheels.turnSpeed())));
  }

  /** Kept free around it, for what it errs about where it is. */
  private double room() {
    return wheels.slip() > 0 ? DEVIATIONS * scanner.matchError() : 0;
  }

  private double stated(String property, double otherwise) {
    return FloorMap.number(device.individual(), property).orElse(otherwise);
  }
}
