package org.maestro.bench;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;

/** A Java process that stands for some hosts; killed when closed. */
final class HostProcess implements AutoCloseable {
  private final Process process;

  private HostProcess(Process process) {
    this.process = process;
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
      Process process =
          new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
      HostProcess host = new HostProcess(process);
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
      process.destroyForcibly();
      throw new IllegalStateException(
          "The process " + name + " ended before its containers were there.");
    }
  }

  /** As a host is that loses its power. */
  void kill() {
    process.destroyForcibly();
  }

  @Override
  public void close() {
    process.destroyForcibly();
  }
}
