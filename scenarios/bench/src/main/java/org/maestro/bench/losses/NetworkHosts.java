package org.maestro.bench.losses;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Hosts with addresses of their own, each a network namespace of this machine, on one bridge whose
 * end here is the platform's host. Their links can be cut, slowed and healed. For one thread.
 */
final class NetworkHosts implements AutoCloseable {
  private static final int LOWEST = 64;
  private static final int NETWORKS = 128;

  private final String id;
  private final int network;
  private final List<String> names = new ArrayList<>();

  private NetworkHosts(int network) {
    this.network = network;
    this.id = "mh" + network;
  }

  /** Whether this machine, and who runs this, can make such hosts. */
  static boolean areThere() {
    String probe = "mprobe" + ProcessHandle.current().pid();
    if (!Files.isExecutable(Path.of("/usr/sbin/ip")) && !Files.isExecutable(Path.of("/sbin/ip"))) {
      return false;
    }
    boolean isMade = isDone("ip", "netns", "add", probe);
    return isMade && isDone("ip", "netns", "del", probe);
  }

  static NetworkHosts open() {
    int network = LOWEST + (int) (ProcessHandle.current().pid() % NETWORKS);
    NetworkHosts hosts = new NetworkHosts(network);
    run("ip", "link", "add", "name", hosts.id, "type", "bridge");
    run("ip", "addr", "add", hosts.address() + "/24", "dev", hosts.id);
    run("ip", "link", "set", hosts.id, "up");
    return hosts;
  }

  /** Of the host on which this process is. */
  String address() {
    return "10.78." + network + ".1";
  }

  /**
   * Adds a host; returns what is to be put before a command that is to run there.
   *
   * @param name at most eight letters
   */
  List<String> add(String name) {
    String space = id + name;
    names.add(name);
    String link = link(name);
    run("ip", "netns", "add", space);
    run("ip", "link", "add", link, "type", "veth", "peer", "name", "eth0", "netns", space);
    run("ip", "link", "set", link, "master", id, "up");
    String address = "10.78." + network + "." + (names.size() + 1) + "/24";
    run("ip", "-n", space, "addr", "add", address, "dev", "eth0");
    run("ip", "-n", space, "link", "set", "eth0", "up");
    run("ip", "-n", space, "link", "set", "lo", "up");
    return List.of("ip", "netns", "exec", space);
  }

  private String link(String name) {
    return id + "v" + names.indexOf(name);
  }

  /** Nothing comes through any more, and nobody is told. */
  void cut(String name) {
    run("ip", "link", "set", link(name), "down");
  }

  /** What was cut comes through again. */
  void heal(String name) {
    run("ip", "link", "set", link(name), "up");
  }

  /**
   * From now on so much comes through at most, each way.
   *
   * @param rate as {@code tc} writes it, such as {@code 256kbit}
   */
  void slow(String name, String rate) {
    List<String> limit = List.of("root", "tbf", "rate", rate, "burst", "32kbit", "latency", "2s");
    List<String> here = new ArrayList<>(List.of("tc", "qdisc", "add", "dev", link(name)));
    here.addAll(limit);
    run(here.toArray(String[]::new));
    List<String> there =
        new ArrayList<>(List.of("tc", "-n", id + name, "qdisc", "add", "dev", "eth0"));
    there.addAll(limit);
    run(there.toArray(String[]::new));
  }

  @Override
  public void close() {
    names.forEach(name -> isDone("ip", "netns", "del", id + name));
    run("ip", "link", "del", id);
  }

  private static void run(String... command) {
    if (!isDone(command)) {
      throw new IllegalStateException("This failed: " + String.join(" ", command));
    }
  }

  private static boolean isDone(String... command) {
    try {
      Process process =
          new ProcessBuilder(command)
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .start();
      return process.waitFor(10, TimeUnit.SECONDS) && process.exitValue() == 0;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("Interrupted while a host was made", e);
    }
  }
}
