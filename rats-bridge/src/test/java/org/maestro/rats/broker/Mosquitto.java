package org.maestro.rats.broker;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.function.IntFunction;
import org.awaitility.Awaitility;

/** The program mosquitto on loopback, in a process of its own that ends with this JVM. */
final class Mosquitto implements TestBroker.Running {

  private static final String HOST = "127.0.0.1";
  private static final int MOST_TRIES = 5;
  private static final Duration LONGEST_START = Duration.ofSeconds(20);

  private final Process process;
  private final Path directory;
  private final int port;
  private final Thread atExit;

  private final String scheme;

  private Mosquitto(Process process, Path directory, int port, String scheme) {
    this.scheme = scheme;
    this.process = process;
    this.directory = directory;
    this.port = port;
    this.atExit = new Thread(process::destroyForcibly, "mosquitto-ends-with-this-process");
    Runtime.getRuntime().addShutdownHook(atExit);
  }

  /**
   * @param port 0 for a free one
   */
  static Mosquitto start(int port) {
    return start(port, "tcp", Mosquitto::open);
  }

  /**
   * With the files of a secured site; the ports that they say are others here.
   *
   * @param mainPort which of their ports is the one that is told
   */
  static Mosquitto startSecured(Path files, int mainPort, int port) {
    return start(
        port,
        "ssl",
        chosen ->
            lines(files.resolve("mosquitto/mosquitto.conf")).stream()
                .map(
                    line ->
                        line.startsWith("listener ")
                            ? "listener "
                                + (line.endsWith(" " + mainPort) ? chosen : freePort())
                                + " "
                                + HOST
                            : line)
                .toList());
  }

  private static Mosquitto start(int port, String scheme, IntFunction<List<String>> configuration) {
    for (int attempt = 1; ; attempt++) {
      int chosen = port == 0 ? freePort() : port;
      Mosquitto started = launch(chosen, scheme, configuration.apply(chosen));
      if (started.listens()) {
        return started;
      }
      String said = started.output();
      started.close();
      if (attempt == MOST_TRIES) {
        throw new IllegalStateException("mosquitto does not start: " + said);
      }
    }
  }

  @Override
  public URI uri() {
    return URI.create(scheme + "://" + HOST + ":" + port);
  }

  @Override
  public void told() {
    try {
      new ProcessBuilder("kill", "-HUP", String.valueOf(process.pid())).start().onExit().join();
    } catch (IOException unable) {
      throw new UncheckedIOException(unable);
    }
  }

  @Override
  public void close() {
    process.destroyForcibly().onExit().join();
    Runtime.getRuntime().removeShutdownHook(atExit);
    try {
      for (String name : List.of("configuration", "output")) {
        Files.delete(directory.resolve(name));
      }
      Files.delete(directory);
    } catch (IOException undeletable) {
      throw new UncheckedIOException(undeletable);
    }
  }

  private static List<String> open(int port) {
    return List.of(
        "listener " + port + " " + HOST,
        "allow_anonymous true",
        "persistence false",
        "set_tcp_nodelay true",
        "max_queued_messages 10000",
        "log_dest stdout",
        "log_type error");
  }

  private static List<String> lines(Path file) {
    try {
      return Files.readAllLines(file);
    } catch (IOException unreadable) {
      throw new UncheckedIOException(unreadable);
    }
  }

  private static Mosquitto launch(int port, String scheme, List<String> lines) {
    try {
      Path directory = Files.createTempDirectory("maestro-mosquitto");
      Path configuration = directory.resolve("configuration");
      Files.write(configuration, lines);
      Process process =
          new ProcessBuilder(
                  RunsProgram.Presence.find("mosquitto").orElseThrow().getPath(),
                  "-c",
                  configuration.toString())
              .redirectErrorStream(true)
              .redirectOutput(directory.resolve("output").toFile())
              .start();
      return new Mosquitto(process, directory, port, scheme);
    } catch (IOException unstartable) {
      throw new UncheckedIOException(unstartable);
    }
  }

  /** Waits until it listens or has ended. */
  private boolean listens() {
    Awaitility.await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(5))
        .atMost(LONGEST_START)
        .until(() -> !process.isAlive() || accepts());
    return process.isAlive();
  }

  private boolean accepts() {
    try (Socket probe = new Socket()) {
      probe.connect(new InetSocketAddress(HOST, port), 1_000);
      return true;
    } catch (IOException notYet) {
      return false;
    }
  }

  private String output() {
    try {
      return Files.readString(directory.resolve("output"));
    } catch (IOException unreadable) {
      throw new UncheckedIOException(unreadable);
    }
  }

  private static int freePort() {
    try (ServerSocket probe = new ServerSocket()) {
      probe.bind(new InetSocketAddress(InetAddress.getByName(HOST), 0));
      return probe.getLocalPort();
    } catch (IOException none) {
      throw new UncheckedIOException(none);
    }
  }
}
