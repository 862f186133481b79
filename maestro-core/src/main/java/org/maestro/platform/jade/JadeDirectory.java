package org.maestro.platform.jade;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;

/**
 * The directory in which JADE writes its files, so that it leaves none in the working directory.
 *
 * @param path of a directory that goes with the platform
 */
public record JadeDirectory(Path path) implements AutoCloseable {
  public static JadeDirectory fresh() {
    try {
      return new JadeDirectory(Files.createTempDirectory("maestro-jade"));
    } catch (IOException e) {
      throw new PlatformStartException("No temporary directory can be made.", e);
    }
  }

  @Override
  public void close() {
    try (var files = Files.walk(path)) {
      files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
    } catch (IOException e) {
      throw new UncheckedIOException("Cannot clean up " + path, e);
    }
  }
}
