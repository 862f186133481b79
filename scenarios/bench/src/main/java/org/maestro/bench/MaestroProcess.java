package org.maestro.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * A command of MAESTRO in a process of its own, which can be killed, frozen and thawed. Closing it
 * leaves nothing behind. For one thread.
 */
public final class MaestroProcess implements AutoCloseable {
  private static final String PROGRAM = "org.maestro.launch.Maestro";

  private final Process process;
  private final Path directory;

  private MaestroProcess(Process process, Path directory) {
    this.process = process;
    this.directory = directory;
  }

  /**
   * @param before what brings it elsewhere, such as {@code ip netns exec NAME}, and becomes the
   *     process itself
   */
  public static MaestroProcess start(List<String> before, List<String> arguments) {
    List<String> command = new ArrayList<>(before);
    command.addAll(
        List.of(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1",
            "-Xshare:auto",
            "-cp",
            System.getProperty("java.class.path"),
            PROGRAM));
    command.addAll(arguments);
    try {
      Path directory = Files.createTempDirectory("maestro-bench");
      ProcessBuilder builder =
          new ProcessBuilder(command)
              .redirectOutput(directory.resolve("output").toFile())
              .redirectError(directory.resolve("errors").toFile());
      builder.environment().put("XDG_RUNTIME_DIR", directory.toString());
      return new MaestroProcess(builder.start(), directory);
    } catch (IOException e) {
      throw new UncheckedIOException("A process for the benchmark could not be started.", e);
    }
  }

  String output() {
    return read("output");
  }

  private String read(String file) {
    try {
      return Files.readString(directory.resolve(file));
    } catch (IOException e) {
      throw new UncheckedIOException("What a process said cannot be read.", e);
    }
  }

  /**
   * Waits until it has said so.
   *
   * @throws IllegalStateException when it ended before, or does not say it in time
   */
  public void awaitSaying(String text) {
    Waiting.until(() -> output().contains(text) || !process.isAlive(), text);
    if (!output().contains(text)) {
      throw new IllegalStateException("A process ended: " + output() + read("errors"));
    }
  }

  /** Waits for its end; returns its exit code. */
  public int awaitEnd(Duration limit) {
    try {
      if (process.waitFor(limit.toMillis(), TimeUnit.MILLISECONDS)) {
        return process.exitValue();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    throw new IllegalStateException("A process did not end: " + output() + read("errors"));
  }

  public boolean isAlive() {
    return process.isAlive();
  }

  /** As a power cut would. */
  public void kill() {
    process.destroyForcibly().onExit().join();
  }

  /** It holds what it has, and does nothing. */
  public void freeze() {
    signal("STOP");
  }

  /** It goes on as if no time had passed. */
  public void thaw() {
    signal("CONT");
  }

  private void signal(String name) {
    try {
      new ProcessBuilder("kill", "-" + name, String.valueOf(process.pid())).start().onExit().join();
    } catch (IOException e) {
      throw new UncheckedIOException("No signal can be sent to a process.", e);
    }
  }

  @Override
  public void close() {
    process.descendants().forEach(ProcessHandle::destroyForcibly);
    kill();
    try (var files = Files.walk(directory)) {
      files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
    } catch (IOException e) {
      throw new UncheckedIOException("Cannot clean up " + directory, e);
    }
  }
}
