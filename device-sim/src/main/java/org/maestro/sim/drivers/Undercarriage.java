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

  private final Device device;
  private final WheelData wheels;
  private final BaseData base;

  /**
   * @param base at the speed of this robot
   */
  Undercarriage(Device device, WheelData wheels, BaseData base) {
    this.device = device;
    this.wheels = wheels;
    this.base = base.ofRadius(stated("bodyRadius", base.radius()));
  }

  BaseData base() {
    return base;
  }

  /** A base whose wheels nobody looks at: it drives to all sides without turning. */
  MobileBase gliding(Actuator actuator) {
    return Wheels.of(device)
        .map(placed -> onWheels(actuator, placed))
        .orElseGet(() -> new SimulatedBase(actuator, base, wheels.slip()));
  }

  /**
   * @param usual how its wheels are placed, unless the home says otherwise
   */
  MobileBase onWheels(Actuator actuator, Wheels usual) {
    WheelGeometry geometry = geometry(Wheels.of(device).orElse(usual));
    SimulatedWheels turning = new SimulatedWheels(actuator, geometry, wheels.slip(), base.radius());
    return new WheeledBase(
        geometry,
        turning,
        turning,
        actuator::after,
        new WheeledBase.Limits(
            base.speed(),
            turnSpeed(),
            base.radius(),
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

  private double stated(String property, double otherwise) {
    return FloorMap.number(device.individual(), property).orElse(otherwise);
  }
}
