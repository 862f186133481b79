package org.maestro.platform.jade;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.locks.LockSupport;

/** Addresses and ports of this machine, and whether somebody answers at others. */
public final class Sockets {
  private static final int LOWEST_PORT = 20_000;
  private static final int HIGHEST_PORT = 32_000;
  private static final int MOST_ATTEMPTS = 1_000;
  private static final Duration BETWEEN_LOOKS = Duration.ofMillis(100);

  private Sockets() {}

  /** On loopback. */
  public static int claim(int port) {
    return claim(Premises.LOOPBACK, port, "--port");
  }

  /**
   * The port asked for if it is free, any free one for 0.
   *
   * @param host an address of this machine
   * @param option by which people choose another
   */
  public static int claim(String host, int port, String option) {
    requireOwn(host);
    if (port == 0) {
      return free(host);
    }
    try (ServerSocket socket = new ServerSocket()) {
      socket.bind(new InetSocketAddress(host, port));
      return port;
    } catch (IOException e) {
      throw new PlatformStartException(
          "Port %d is in use; stop what listens there, or choose another with %s."
              .formatted(port, option),
          e);
    }
  }

  private static void requireOwn(String host) {
    try {
      if (NetworkInterface.getByInetAddress(InetAddress.getByName(host)) != null) {
        return;
      }
    } catch (IOException e) {
      throw notOwn(host);
    }
    throw notOwn(host);
  }

  private static PlatformStartException notOwn(String host) {
    return new PlatformStartException(
        "%s is no address of this machine; name one of its own, or leave it away for %s."
            .formatted(host, Premises.LOOPBACK));
  }

  /**
   * Not one of those that the system gives to outgoing connections: among those another may get it
   * before JADE does.
   */
  static int free(String host) {
    Optional<IOException> last = Optional.empty();
    for (int attempt = 0; attempt < MOST_ATTEMPTS; attempt++) {
      int port = ThreadLocalRandom.current().nextInt(LOWEST_PORT, HIGHEST_PORT);
      last = whyNotFree(host, port);
      if (last.isEmpty()) {
        return port;
      }
    }
    throw new PlatformStartException(
        "No free port on %s: %s."
            .formatted(host, last.map(IOException::getMessage).orElse("none was tried")));
  }

  public static boolean isFree(String host, int port) {
    return whyNotFree(host, port).isEmpty();
  }

  /** Returns when it is free, or when that lasts too long. */
  public static void awaitFree(String host, int port, Duration atMost) {
    long until = System.nanoTime() + atMost.toNanos();
    while (!isFree(host, port) && System.nanoTime() < until) {
      LockSupport.parkNanos(BETWEEN_LOOKS.toNanos());
    }
  }

  private static Optional<IOException> whyNotFree(String host, int port) {
    try {
      new ServerSocket(port, 1, InetAddress.getByName(host)).close();
      return Optional.empty();
    } catch (IOException taken) {
      return Optional.of(taken);
    }
  }

  /** The address of this machine from which one is reached there; empty when nobody answers. */
  static Optional<String> addressTowards(String host, int port) {
    try (Socket socket = new Socket()) {
      socket.connect(new InetSocketAddress(InetAddress.getByName(host), port), 2_000);
      return Optional.of(socket.getLocalAddress().getHostAddress());
    } catch (IOException e) {
      return Optional.empty();
    }
  }
}
