package org.maestro.sim;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import org.maestro.hal.Camera;
import org.maestro.hal.DaylightSensor;
import org.maestro.hal.DimmableLamp;
import org.maestro.hal.DoorDrive;
import org.maestro.hal.Drivers;
import org.maestro.hal.GripperArm;
import org.maestro.hal.IlluminationSensor;
import org.maestro.hal.MobileBase;
import org.maestro.hal.Position;
import org.maestro.hal.ShutterDrive;
import org.maestro.hal.Surroundings;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Glass;
import org.maestro.ontology.home.Pose;
import org.maestro.ontology.home.Windows;
import org.maestro.rats.time.Clock;

/**
 * Makes simulated drivers for the driver keys of device descriptions, and puts the devices into the
 * world.
 */
final class DriverFactory {

  private static final double USUAL_BEAM_DEGREES = 120;
  private static final double FULL_STRENGTH = 1;

  private final World world;
  private final Scene scene;
  private final Clock clock;
  private final PhysicalParameters parameters;
  private final Windows windows;

  DriverFactory(
      World world, Scene scene, Clock clock, PhysicalParameters parameters, Windows windows) {
    this.world = world;
    this.scene = scene;
    this.clock = clock;
    this.parameters = parameters;
    this.windows = windows;
  }

  /**
   * @param key of the device's description
   * @throws SimulationException when there is no such driver, or home and scene lack what it needs
   */
  Drivers drivers(Device device, String key, Random random) {
    Actuator actuator = new Actuator(device.id(), world, clock, random);
    return switch (key) {
      case "lamp" -> lamp(device, actuator);
      case "camera" ->
          Drivers.none()
              .with(
                  Camera.class,
                  new SimulatedCamera(
                      actuator, parameters.camera(), pose(device), number(device, "viewAngle")));
      case "light-sensor" -> {
        Pose pose = pose(device);
        Position place = new Position(pose.x(), pose.y(), pose.z());
        yield Drivers.none()
            .with(
                IlluminationSensor.class,
                new SimulatedSensor(actuator, parameters.sensor(), place));
      }
      case "door" ->
          Drivers.none().with(DoorDrive.class, new SimulatedDoor(actuator, parameters.drives()));
      case "shutter" -> shutter(device, actuator);
      case "mobile-robot" -> robot(device, actuator);
      case "mobile-robot-with-camera" ->
          robot(device, actuator)
              .with(
                  Camera.class,
                  SimulatedCamera.onBoard(
                      actuator,
                      parameters.camera(),
                      parameters.turn(),
                      number(device, "viewAngle")));
      default ->
          throw new SimulationException(
              "The driver "
                  + key
                  + " of "
                  + device.id()
                  + " cannot be simulated; known are lamp, camera, light-sensor, door, shutter, mobile-robot,"
                  + " mobile-robot-with-camera.");
    };
  }

  private Drivers lamp(Device device, Actuator actuator) {
    Scene.Entry entry = scene.of(device.id());
    OptionalDouble beam = FloorMap.number(device.individual(), "beamAngle");
    world.addLamp(
        device.id(),
        new LampLight(
            pose(device),
            number(device, "luminousIntensity"),
            beam.orElse(USUAL_BEAM_DEGREES),
            entry.strength().orElse(FULL_STRENGTH),
            entry.level().orElse(0)));
    return Drivers.none().with(DimmableLamp.class, new SimulatedLamp(actuator, parameters.lamp()));
  }

  private Drivers shutter(Device device, Actuator actuator) {
    Drivers drivers =
        Drivers.none()
            .with(ShutterDrive.class, new SimulatedShutter(actuator, parameters.drives()));
    List<Glass> shaded = windows.shadedBy(device.id()).stream().map(Windows.Window::glass).toList();
    return shaded.isEmpty() || scene.sky().isEmpty()
        ? drivers
        : drivers.with(
            DaylightSensor.class,
            SimulatedDaylightSensor.start(actuator, parameters.facade(), shaded));
  }

  private Drivers robot(Device device, Actuator actuator) {
    Body body =
        world
            .findBody(device.id())
            .orElseThrow(
                () ->
                    new SimulationException(
                        "The scene "
                            + scene.name()
                            + " does not say where "
                            + device.id()
                            + " stands. Give it a scene:position."));
    world.put(body.withRadius(parameters.base().radius()));
    Scene.Entry truth = scene.of(device.id());
    PhysicalParameters.BaseData base =
        parameters.base().atSpeed(truth.speed().orElse(parameters.base().speed()));
    PhysicalParameters.ArmData arm =
        parameters.arm().lifting(truth.payload().orElse(parameters.arm().payload()));
    return Drivers.none()
        .with(MobileBase.class, new SimulatedBase(actuator, base))
        .with(GripperArm.class, new SimulatedArm(actuator, arm))
        .with(Surroundings.class, new OnBoardMap(device.id(), world));
  }

  private static Pose pose(Device device) {
    return FloorMap.pose(device.individual(), "pose").orElseThrow(() -> lacking(device, "pose"));
  }

  private static double number(Device device, String property) {
    return FloorMap.number(device.individual(), property)
        .orElseThrow(() -> lacking(device, property));
  }

  private static SimulationException lacking(Device device, String property) {
    return new SimulationException(
        device.id()
            + " has no maestro:"
            + property
            + ", without which it cannot be simulated. Add it to the home file.");
  }
}
