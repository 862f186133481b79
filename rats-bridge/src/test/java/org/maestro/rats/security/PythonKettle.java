package org.maestro.rats.security;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The example of a device in Python, in a process of its own. */
final class PythonKettle implements AutoCloseable {

  static final String ID = "kettle-1";

  /** How it is written: with the MQTT client alone, or with the package for devices. */
  enum Script {
    BARE("../docs/examples/kettle.py"),
    WITH_PACKAGE("python/examples/kettle.py");

    private final Path file;

    Script(String file) {
      this.file = Path.of(file);
    }
  }

  private final Process process;

  private PythonKettle(Process process) {
    this.process = process;
  }

  /**
   * @param folder its own of a secured site
   */
  static PythonKettle start(Script script, URI broker, String site, Optional<Path> folder)
      throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                "python3",
                script.file.toString(),
                broker.getHost(),
                String.valueOf(broker.getPort()),
                site));
    folder.ifPresent(own -> command.add(own.toString()));
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true).inheritIO();
    builder.environment().put("PYTHONPATH", Path.of("python", "src").toString());
    builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
    return new PythonKettle(builder.start());
  }

  /** As when its power fails. */
  void kill() {
    process.destroyForcibly();
  }

  boolean hasEnded() {
    return !process.isAlive();
  }

  @Override
  public void close() {
    process.destroyForcibly();
  }
}
