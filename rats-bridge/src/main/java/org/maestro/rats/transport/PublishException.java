package org.maestro.rats.transport;

/** A message did not get to the broker, or the broker refused it. */
public final class PublishException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  PublishException(String topic, String reason) {
    super("The message for the topic " + topic + " was not published: " + reason);
  }
}
