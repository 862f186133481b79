package org.maestro.rats.broker;

/** The embedded broker could not start, mostly because its port is taken. */
public final class BrokerStartException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  BrokerStartException(int port, Throwable cause) {
    super(message(port), cause);
  }

  BrokerStartException(int port) {
    super(message(port));
  }

  BrokerStartException(String message, Throwable cause) {
    super(message, cause);
  }

  private static String message(int port) {
    return "The embedded MQTT broker could not listen on 127.0.0.1:"
        + port
        + "; free that port or choose another";
  }
}
