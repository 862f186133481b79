package org.maestro.launch;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.net.URI;
import java.net.URISyntaxException;
import java.util.Set;

/** A host and a port that a user gave. */
record Endpoint(String host, int port) {
  private static final int CONNECT_MILLIS = 2_000;

  /** Reads {@code HOST:PORT}. */
  static Endpoint parse(String text) {
    int colon = text.lastIndexOf(':');
    try {
      int port = Integer.parseInt(text.substring(colon + 1));
      if (colon > 0 && port > 0 && port < 65_536) {
        return new Endpoint(text.substring(0, colon), port);
      }
    } catch (NumberFormatException e) {
      throw notAnEndpoint(text);
    }
    throw notAnEndpoint(text);
  }

  /**
   * Reads {@code [HOST:]PORT} on which to listen; a port 0 is any free one.
   *
   * @param usual host when none is named
   */
  static Endpoint listening(String text, String usual) {
    int colon = text.lastIndexOf(':');
    try {
      int port = Integer.parseInt(text.substring(colon + 1));
      if (colon != 0 && port >= 0 && port < 65_536) {
        return new Endpoint(colon < 0 ? usual : text.substring(0, colon), port);
      }
    } catch (NumberFormatException e) {
      throw notAPort(text);
    }
    throw notAPort(text);
  }

  private static CommandException notAPort(String text) {
    return CommandException.badInput(
        "\"" + text + "\" is no port to listen on; write PORT or HOST:PORT, such as 7778.");
  }

  private static CommandException notAnEndpoint(String text) {
    return CommandException.badInput(
        "\"" + text + "\" is no address; write HOST:PORT, such as 127.0.0.1:1099.");
  }

  /** Reads a broker's URI, and makes sure that something answers there. */
  static URI broker(String text) {
    try {
      URI uri = new URI(text);
      if (!Set.of("tcp", "ssl").contains(String.valueOf(uri.getScheme()))
          || uri.getHost() == null
          || uri.getPort() < 0) {
        throw CommandException.badInput(
            "\""
                + text
                + "\" is no broker; write tcp://HOST:PORT, or ssl://HOST:PORT when it is secured.");
      }
      new Endpoint(uri.getHost(), uri.getPort()).requireAnswer(text);
      return uri;
    } catch (URISyntaxException e) {
      throw CommandException.badInput(
          "\""
              + text
              + "\" is no broker; write tcp://HOST:PORT, or ssl://HOST:PORT when it is secured.");
    }
  }

  /** Whether anything listens there. */
  boolean answers() {
    try (Socket socket = new Socket()) {
      socket.connect(new InetSocketAddress(host, port), CONNECT_MILLIS);
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  private void requireAnswer(String name) {
    try (Socket socket = new Socket()) {
      socket.connect(new InetSocketAddress(host, port), CONNECT_MILLIS);
    } catch (IOException e) {
      throw CommandException.outside(
          "No MQTT broker answers at " + name + "; start one there, or leave --broker away.", e);
    }
  }
}
