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

  private final Process process;

  private PythonKettle(Process process) {
    this.process = process;
  }

  /**
   * @param folder its own of a secured site
   */
  static PythonKettle start(URI broker, String site, Optional<Path> folder) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                "python3",
                Path.of("..", "docs", "examples", "kettle.py").toString(),
                broker.getHost(),
                String.valueOf(broker.getPort()),
                site));
    folder.ifPresent(own -> command.add(own.toString()));
    return new PythonKettle(
        new ProcessBuilder(command).redirectErrorStream(true).inheritIO().start());
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
