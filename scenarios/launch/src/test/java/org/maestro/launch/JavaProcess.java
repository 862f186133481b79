package org.maestro.launch;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/**
 * Another Java process with the class path of the tests; ended with everything it started when
 * closed.
 */
public final class JavaProcess implements AutoCloseable {

  /** How a process ended, and what it said. */
  public record Ended(int exitCode, String output, String errors) {}

  private final Process process;
  private final Path output;
  private final Path errors;

  private JavaProcess(Process process, Path output, Path errors) {
    this.process = process;
    this.output = output;
    this.errors = errors;
  }

  /** Starts a main class. */
  public static JavaProcess start(String mainClass, List<String> arguments) throws IOException {
    return start(mainClass, arguments, Map.of());
  }

  /**
   * @param environment what differs from this process's; an empty value removes the variable
   */
  public static JavaProcess start(
      String mainClass, List<String> arguments, Map<String, String> environment)
      throws IOException {
    return start(List.of(), mainClass, arguments, environment);
  }

  /** Starts a main class that finds these classes too, which nobody else has. */
  public static JavaProcess startWith(Path classes, String mainClass, List<String> arguments)
      throws IOException {
    return start(List.of(), List.of(), mainClass, arguments, Map.of(), classes.toString());
  }

  /** Starts a main class that logs as it does for its users: more than tests do, and to a file. */
  public static JavaProcess startLogging(
      String mainClass, List<String> arguments, Map<String, String> environment)
      throws IOException {
    return start(
        List.of(),
        List.of("-Dlogback.configurationFile=logback.xml"),
        mainClass,
        arguments,
        environment);
  }

  /**
   * @param before what brings it elsewhere, such as {@code ip netns exec NAME}, and becomes the
   *     process itself
   * @param environment what differs from this process's; an empty value removes the variable
   */
  public static JavaProcess start(
      List<String> before,
      String mainClass,
      List<String> arguments,
      Map<String, String> environment)
      throws IOException {
    return start(before, List.of(), mainClass, arguments, environment);
  }

  private static JavaProcess start(
      List<String> before,
      List<String> options,
      String mainClass,
      List<String> arguments,
      Map<String, String> environment)
      throws IOException {
    return start(before, options, mainClass, arguments, environment, "");
  }

  private static JavaProcess start(
      List<String> before,
      List<String> options,
      String mainClass,
      List<String> arguments,
      Map<String, String> environment,
      String classesOfItsOwn)
      throws IOException {
    List<String> command = new ArrayList<>(before);
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-Xshare:auto"));
    command.addAll(options);
    String classes = System.getProperty("java.class.path");
    command.addAll(
        List.of(
            "-cp",
            classesOfItsOwn.isEmpty() ? classes : classes + File.pathSeparator + classesOfItsOwn,
            mainClass));
    command.addAll(arguments);
    Path output = Files.createTempFile("maestro-process", ".out");
    Path errors = Files.createTempFile("maestro-process", ".err");
    ProcessBuilder builder =
        new ProcessBuilder(command)
            .redirectOutput(output.toFile())
            .redirectError(errors.toFile())
            .redirectInput(ProcessBuilder.Redirect.from(Path.of("/dev/null").toFile()));
    environment.forEach(
        (name, value) -> {
          if (value.isEmpty()) {
            builder.environment().remove(name);
          } else {
            builder.environment().put(name, value);
          }
        });
    return new JavaProcess(builder.start(), output, errors);
  }

  /** Waits for its end; one that does not end in time has failed the test. */
  public Ended await(Duration limit) throws InterruptedException {
    if (!process.waitFor(limit.toMillis(), TimeUnit.MILLISECONDS)) {
      throw new AssertionError(
          "The process did not end within %d s; it said: %s%s"
              .formatted(limit.toSeconds(), output(), read(errors)));
    }
    return new Ended(process.exitValue(), output(), read(errors));
  }

  public long pid() {
    return process.pid();
  }

  public boolean isAlive() {
    return process.isAlive();
  }

  public String output() {
    return read(output);
  }

  public String errors() {
    return read(errors);
  }

  /** Ends it as a power cut would: it has no moment left. */
  public void kill() {
    process.destroyForcibly().onExit().join();
  }

  /** Stops it as it stands: it holds what it has, and does nothing. */
  public void freeze() {
    signal("STOP");
  }

  /** It goes on as if no time had passed. */
  public void thaw() {
    signal("CONT");
  }

  /** Sends a signal, such as TERM. */
  void signal(String name) {
    try {
      int code =
          new ProcessBuilder("kill", "-" + name, String.valueOf(process.pid()))
              .inheritIO()
              .start()
              .waitFor();
      if (code != 0) {
        throw new AssertionError("The signal " + name + " could not be sent: exit code " + code);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new AssertionError("Interrupted while a signal was sent", e);
    }
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() throws IOException {
    process.descendants().forEach(ProcessHandle::destroyForcibly);
    process.destroyForcibly().onExit().join();
    Files.deleteIfExists(output);
    Files.deleteIfExists(errors);
  }
}
