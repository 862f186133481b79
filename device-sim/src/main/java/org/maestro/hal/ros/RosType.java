package org.maestro.hal.ros;

/** The types of messages that are used here, by their package and name. */
public enum RosType {
  TWIST("geometry_msgs", "Twist"),
  TWIST_STAMPED("geometry_msgs", "TwistStamped"),
  ODOMETRY("nav_msgs", "Odometry"),
  POSE("geometry_msgs", "PoseWithCovarianceStamped"),
  ILLUMINANCE("sensor_msgs", "Illuminance"),
  TEMPERATURE("sensor_msgs", "Temperature"),
  DETECTIONS("vision_msgs", "Detection3DArray"),
  IMAGE("sensor_msgs", "CompressedImage");

  private final String home;
  private final String title;

  RosType(String home, String title) {
    this.home = home;
    this.title = title;
  }

  /** The ROS package that defines it. */
  String home() {
    return home;
  }

  String title() {
    return title;
  }
}
