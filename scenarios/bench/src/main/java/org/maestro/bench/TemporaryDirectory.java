package org.maestro.bench;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Stream;
import org.maestro.assembly.SiteException;

/** A directory of a benchmark, which goes with all that is in it when it is closed. */
public record TemporaryDirectory(Path path) implements AutoCloseable {
  public static TemporaryDirectory make() {
    try {
      return new TemporaryDirectory(Files.createTempDirectory("maestro-bench"));
    } catch (IOException e) {
      throw new SiteException("No temporary directory can be made.", e);
    }
  }

  @Override
  public void close() {
    try (Stream<Path> files = Files.walk(path)) {
      files.sorted(Comparator.reverseOrder()).forEach(file -> file.toFile().delete());
    } catch (IOException e) {
      throw new SiteException("Cannot clean up " + path + ".", e);
    }
  }
}
