package org.maestro.hal.ros;

/** The two generations of ROS, which name types of messages differently. */
public enum RosVersion {
  ROS_1("%s/%s"),
  ROS_2("%s/msg/%s");

  private final String form;

  RosVersion(String form) {
    this.form = form;
  }

  String typeName(RosType type) {
    return form.formatted(type.home(), type.title());
  }
}
