package org.maestro.platform.threads;

import java.io.IOException;
import java.io.Reader;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Properties;
import java.util.stream.Stream;

/** The Javas that stand beside the one that runs this. */
final class OtherJava {

  private OtherJava() {}

  /** The program {@code java} of one of that version or newer. */
  static Optional<Path> atLeast(int version) {
    Path home = Path.of(System.getProperty("java.home")).toAbsolutePath();
    Optional<Path> named = Optional.ofNullable(System.getenv("JAVA_OTHER_HOME")).map(Path::of);
    try (Stream<Path> beside = Files.list(home.getParent())) {
      return Stream.concat(named.stream(), beside.sorted())
          .filter(candidate -> feature(candidate) >= version)
          .map(candidate -> candidate.resolve("bin").resolve("java"))
          .filter(Files::isExecutable)
          .findFirst();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** As the file {@code release} of an installation says; 0 where there is none. */
  private static int feature(Path home) {
    Path release = home.resolve("release");
    if (!Files.isReadable(release)) {
      return 0;
    }
    Properties properties = new Properties();
    try (Reader reader = Files.newBufferedReader(release)) {
      properties.load(reader);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    String version = properties.getProperty("JAVA_VERSION", "0").replace("\"", "");
    return Runtime.Version.parse(version.replaceAll("[^0-9.].*", "")).feature();
  }
}
