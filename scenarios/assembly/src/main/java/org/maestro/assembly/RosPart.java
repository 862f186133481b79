package org.maestro.assembly;

import java.util.Optional;
import org.maestro.hal.ros.RosBase;
import org.maestro.hal.ros.RosCamera;
import org.maestro.hal.wheels.Stance;
import org.maestro.ontology.home.Device;

/** Hardware behind ROS that is a device of a home. */
public sealed interface RosPart {

  Device device();

  /**
   * A robot's base.
   *
   * @param place where it stands when it is first heard; empty: where its pose says
   */
  record Robot(Device device, RosBase.Topics topics, Optional<Stance> place) implements RosPart {}

  /**
   * A light sensor or a thermometer, whichever the device is.
   *
   * @param topic tells sensor_msgs/Illuminance or sensor_msgs/Temperature
   */
  record Sensor(Device device, String topic) implements RosPart {}

  /** A camera with a detector. */
  record Camera(Device device, RosCamera.Topics topics) implements RosPart {}
}
