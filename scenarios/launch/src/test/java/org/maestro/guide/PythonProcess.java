package org.maestro.guide;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** A device of a stranger in a process of its own, and what it prints. */
final class PythonProcess implements AutoCloseable {
  private final Path printed;
  private final Process process;

  /**
   * @param script of the test resources in {@code devices}
   * @param directory where it is kept what it prints
   * @param arguments after the broker's address and the site's name
   */
  PythonProcess(String script, Path directory, URI broker, String site, String... arguments)
      throws Exception {
    printed = Files.createTempFile(directory, "device", ".txt");
    List<String> command = new ArrayList<>();
    command.add("python3");
    command.add(Path.of(PythonProcess.class.getResource("/devices/" + script).toURI()).toString());
    command.addAll(List.of(broker.getHost(), String.valueOf(broker.getPort()), site));
    command.addAll(List.of(arguments));
    ProcessBuilder builder =
        new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(printed.toFile());
    builder
        .environment()
        .put("PYTHONPATH", Path.of("..", "..", "rats-bridge", "python", "src").toString());
    builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
    process = builder.start();
  }

  /** Tells in the test's output when it cannot be shown here. */
  static void assumePython() throws InterruptedException {
    assumeTrue(
        PythonDeviceInAPlanTest.hasPython(),
        "python3 with paho-mqtt is not installed; .ci/run installs them");
  }

  /** Those lines that begin so. */
  List<String> lines(String word) {
    try {
      return Files.readAllLines(printed).stream().filter(line -> line.startsWith(word)).toList();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public void close() {
    process.destroyForcibly().onExit().join();
  }
}
