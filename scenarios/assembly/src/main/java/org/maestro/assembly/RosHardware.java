package org.maestro.assembly;

import java.util.Optional;
import java.util.function.Supplier;
import org.maestro.device.tasks.DeviceSetupException;
import org.maestro.hal.Camera;
import org.maestro.hal.Drivers;
import org.maestro.hal.IlluminationSensor;
import org.maestro.hal.Thermometer;
import org.maestro.hal.ros.RosBase;
import org.maestro.hal.ros.RosBridge;
import org.maestro.hal.ros.RosCamera;
import org.maestro.hal.ros.RosLightSensor;
import org.maestro.hal.ros.RosThermometer;
import org.maestro.hal.wheels.WheeledBase;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.Clock;
import org.maestro.sim.parameters.CameraData;
import org.maestro.sim.world.FloorMap;

/**
 * The drivers of a device behind ROS.
 *
 * @param fault why nothing is known of it, or it cannot be told anything; asked on the clock's
 *     thread
 * @param rest has it stand still, on the clock's thread
 */
record RosHardware(Drivers drivers, Supplier<Optional<String>> fault, Runnable rest) {

  private static final String MEASURES_LIGHT = "measureIllumination";
  private static final String TEMPERATURE = "temperature";

  /**
   * Listens to the part's topics from now on.
   *
   * @throws DeviceSetupException with one sentence when the device is no such part
   */
  static RosHardware of(RosPart part, Home home, RosBridge bridge, Clock clock) {
    if (part instanceof RosPart.Robot robot) {
      return base(robot, home, bridge, clock);
    }
    return part instanceof RosPart.Camera camera
        ? camera(camera, bridge, clock)
        : sensor((RosPart.Sensor) part, bridge, clock);
  }

  private static RosHardware base(RosPart.Robot robot, Home home, RosBridge bridge, Clock clock) {
    StatedBase stated = new StatedBase(home, robot.device(), clock);
    RosBase ros =
        new RosBase(
            bridge,
            robot.topics(),
            stated.wheels(),
            robot.place(),
            stated.speed(),
            stated.isFree(),
            stated.pace());
    WheeledBase base = stated.on(ros, ros);
    return new RosHardware(stated.drivers(base), ros::silence, base::stop);
  }

  private static RosHardware camera(RosPart.Camera eye, RosBridge bridge, Clock clock) {
    CameraData usual = CameraData.LIFECAM;
    RosCamera.Light light =
        new RosCamera.Light(
            stated(eye.device(), "minimumLight", usual.minimumLux()),
            stated(eye.device(), "maximumLight", usual.maximumLux()));
    RosCamera camera =
        new RosCamera(bridge, eye.topics(), light, StatedBase.pace(eye.device(), clock));
    return new RosHardware(Drivers.none().with(Camera.class, camera), camera::fault, () -> {});
  }

  private static double stated(Device device, String word, double otherwise) {
    return device
        .propertyCalled(word)
        .map(property -> FloorMap.number(device.individual(), property).orElse(otherwise))
        .orElse(otherwise);
  }

  private static RosHardware sensor(RosPart.Sensor sensor, RosBridge bridge, Clock clock) {
    Device device = sensor.device();
    if (device.features().stream().anyMatch(type -> type.procedure().equals(MEASURES_LIGHT))) {
      RosLightSensor light =
          new RosLightSensor(bridge, sensor.topic(), StatedBase.pace(device, clock));
      return new RosHardware(
          Drivers.none().with(IlluminationSensor.class, light), light::fault, () -> {});
    } else if (device.reports().containsKey(TEMPERATURE)) {
      RosThermometer warmth = new RosThermometer(bridge, sensor.topic());
      return new RosHardware(
          Drivers.none().with(Thermometer.class, warmth), warmth::fault, () -> {});
    }
    throw new DeviceSetupException(
        "The device %s is no sensor that ROS is read for: it offers nothing with the procedure %s, and reports no %s."
            .formatted(device.id(), MEASURES_LIGHT, TEMPERATURE));
  }
}
