package org.maestro.bench.containers;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** A Java process that stands for some hosts; killed when closed. */
final class HostProcess implements AutoCloseable {
  private final Process process;
  private final Path errors;

  private HostProcess(Process process, Path errors) {
    this.process = process;
    this.errors = errors;
  }

  /**
   * Starts it and waits until its containers are there.
   *
   * @param port of the platform
   * @param first number of its first container
   */
  static HostProcess start(int port, String name, int first, int containers) {
    List<String> command =
        List.of(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1",
            "-Xshare:auto",
            "-Xmx96m",
            "-Xss512k",
            "-cp",
            System.getProperty("java.class.path"),
            ManyContainers.class.getName(),
            String.valueOf(port),
            name,
            String.valueOf(first),
            String.valueOf(containers));
    try {
      Path errors = Files.createTempFile("maestro-host", ".err");
      HostProcess host =
          new HostProcess(
              new ProcessBuilder(command).redirectError(errors.toFile()).start(), errors);
      host.awaitReady(name);
      return host;
    } catch (IOException e) {
      throw new UncheckedIOException("The process " + name + " could not be started.", e);
    }
  }

  private void awaitReady(String name) throws IOException {
    BufferedReader out =
        new BufferedReader(new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    String line = out.readLine();
    while (line != null && !line.equals(ManyContainers.READY)) {
      line = out.readLine();
    }
    if (line == null) {
      String said = Files.readString(errors).strip();
      close();
      throw new IllegalStateException(
          "The process %s ended before its containers were there: %s".formatted(name, said));
    }
  }

  /** As a host is that loses its power. */
  void kill() {
    process.destroyForcibly();
  }

  @Override
  public void close() {
    process.destroyForcibly().onExit().join();
    try {
      Files.deleteIfExists(errors);
    } catch (IOException e) {
      throw new UncheckedIOException("Cannot clean up " + errors, e);
    }
  }
}
