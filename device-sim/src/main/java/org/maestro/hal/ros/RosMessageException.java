package org.maestro.hal.ros;

/** A message from ROS is not what its type says; the message says which part of it. */
final class RosMessageException extends RuntimeException {
  private static final long serialVersionUID = 1;

  RosMessageException(String message) {
    super(message);
  }
}
