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
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.function.Function;
import org.awaitility.Awaitility;

/** The program mosquitto on loopback, in a process of its own that ends with this JVM. */
final class Mosquitto implements TestBroker.Running {

  private static final String HOST = "127.0.0.1";
  private static final int MOST_TRIES = 5;
  private static final Duration LONGEST_START = Duration.ofSeconds(20);

  /**
   * @param ports all that it listens on; the first is the one that is told
   */
  private record Configuration(String scheme, List<Integer> ports, List<String> lines) {}

  private final Process process;
  private final Path directory;
  private final Configuration configuration;
  private final Thread atExit;

  private Mosquitto(Process process, Path directory, Configuration configuration) {
    this.process = process;
    this.directory = directory;
    this.configuration = configuration;
    this.atExit = new Thread(process::destroyForcibly, "mosquitto-ends-with-this-process");
    Runtime.getRuntime().addShutdownHook(atExit);
  }

  /**
   * @param port 0 for a free one
   */
  static Mosquitto start(int port) {
    return start(port, 1, Mosquitto::open);
  }

  /**
   * With the files of a secured site; the ports that they say are others here.
   *
   * @param mainPort which of their ports is the one that is told
   */
  static Mosquitto startSecured(Path files, int mainPort, int port) {
    List<String> lines = lines(files.resolve("mosquitto/mosquitto.conf"));
    int listeners = Math.toIntExact(lines.stream().filter(Mosquitto::isListener).count());
    return start(port, listeners, ports -> secured(lines, mainPort, ports));
  }

  private static Mosquitto start(
      int port, int listeners, Function<List<Integer>, Configuration> configured) {
    for (int attempt = 1; ; attempt++) {
      List<Integer> ports = new ArrayList<>(freePorts(listeners));
      if (port != 0) {
        ports.set(0, port);
      }
      Mosquitto started = launch(configured.apply(ports));
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
    return URI.create(configuration.scheme() + "://" + HOST + ":" + configuration.ports().get(0));
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

  private static Configuration open(List<Integer> ports) {
    return new Configuration(
        "tcp",
        ports,
        List.of(
            "listener " + ports.get(0) + " " + HOST,
            "allow_anonymous true",
            "persistence false",
            "set_tcp_nodelay true",
            "max_queued_messages 10000",
            "log_dest stdout",
            "log_type error"));
  }

  private static Configuration secured(List<String> lines, int mainPort, List<Integer> ports) {
    Iterator<Integer> others = ports.listIterator(1);
    return new Configuration(
        "ssl",
        ports,
        lines.stream()
            .map(
                line ->
                    isListener(line)
                        ? "listener "
                            + (line.endsWith(" " + mainPort) ? ports.get(0) : others.next())
                            + " "
                            + HOST
                        : line)
            .toList());
  }

  private static boolean isListener(String line) {
    return line.startsWith("listener ");
  }

  private static List<String> lines(Path file) {
    try {
      return Files.readAllLines(file);
    } catch (IOException unreadable) {
      throw new UncheckedIOException(unreadable);
    }
  }

  private static Mosquitto launch(Configuration configuration) {
    try {
      Path directory = Files.createTempDirectory("maestro-mosquitto");
      Path file = directory.resolve("configuration");
      Files.write(file, configuration.lines());
      Process process =
          new ProcessBuilder(
                  RunsProgram.Presence.find("mosquitto").orElseThrow().getPath(),
                  "-c",
                  file.toString())
              .redirectErrorStream(true)
              .redirectOutput(directory.resolve("output").toFile())
              .start();
      return new Mosquitto(process, directory, configuration);
    } catch (IOException unstartable) {
      throw new UncheckedIOException(unstartable);
    }
  }

  /**
   * Waits until it listens on all its ports or has ended: it opens them one by one, and ends when
   * somebody else has one of them.
   */
  private boolean listens() {
    Awaitility.await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(5))
        .atMost(LONGEST_START)
        .until(
            () ->
                !process.isAlive() || configuration.ports().stream().allMatch(Mosquitto::accepts));
    return process.isAlive();
  }

  private static boolean accepts(int port) {
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

  /** Ports that are free together: each is held until all are known. */
  private static List<Integer> freePorts(int count) {
    List<ServerSocket> held = new ArrayList<>();
    try {
      for (int index = 0; index < count; index++) {
        ServerSocket probe = new ServerSocket();
        held.add(probe);
        probe.bind(new InetSocketAddress(InetAddress.getByName(HOST), 0));
      }
      List<Integer> ports = held.stream().map(ServerSocket::getLocalPort).toList();
      for (ServerSocket probe : held) {
        probe.close();
      }
      return ports;
    } catch (IOException none) {
      throw new UncheckedIOException(none);
    }
  }
}
