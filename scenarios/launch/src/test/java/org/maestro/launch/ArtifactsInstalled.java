package org.maestro.launch;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.stream.Stream;

/**
 * The artifacts of this build, as {@code mvn install} puts them into a local repository, in one
 * that is nobody's: what is not ours is linked from the one that the build uses, which stays as it
 * is.
 */
record ArtifactsInstalled(Path repository) implements AutoCloseable {
  private static final String OURS = "META-INF/maven/org.maestro/";
  private static final Path ROOT = Path.of("..", "..");

  /** Where they are not built, or Maven did not start the test, the test is skipped. */
  static ArtifactsInstalled in(Path repository) throws IOException {
    String others = System.getProperty("maestro.repository");
    assumeTrue(others != null, "Maven does not run this test; mvn verify does");
    List<Path> jars =
        Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
            .map(Path::of)
            .filter(entry -> entry.toString().endsWith(".jar") && descriptor(entry).isPresent())
            .toList();
    assumeTrue(!jars.isEmpty(), "The artifacts are not built here; mvn verify builds them first");

    link(Path.of(others), repository, "org");
    link(Path.of(others, "org"), repository.resolve("org"), "maestro");
    install(repository, "maestro", ROOT.resolve("pom.xml"));
    install(repository, "scenarios", ROOT.resolve("scenarios/pom.xml"));
    for (Path jar : jars) {
      install(repository, jar);
    }
    return new ArtifactsInstalled(repository);
  }

  /** Takes the links away: what they lead to is not to be deleted with the repository. */
  @Override
  public void close() throws IOException {
    try (Stream<Path> parts = Files.walk(repository, 2)) {
      for (Path link : parts.filter(Files::isSymbolicLink).toList()) {
        Files.delete(link);
      }
    }
  }

  private static void link(Path from, Path to, String butFor) throws IOException {
    Files.createDirectories(to);
    try (Stream<Path> parts = Files.list(from)) {
      for (Path part : parts.filter(each -> !each.endsWith(butFor)).toList()) {
        Files.createSymbolicLink(to.resolve(part.getFileName()), part);
      }
    }
  }

  private static void install(Path repository, String artifact, Path pom) throws IOException {
    Files.copy(pom, file(repository, artifact, "pom"));
  }

  private static void install(Path repository, Path jar) throws IOException {
    try (JarFile content = new JarFile(jar.toFile())) {
      JarEntry pom = descriptor(jar).orElseThrow();
      String artifact = Path.of(pom.getName()).getParent().getFileName().toString();
      Files.copy(jar, file(repository, artifact, "jar"));
      try (InputStream stream = content.getInputStream(pom)) {
        Files.copy(stream, file(repository, artifact, "pom"));
      }
    }
  }

  private static Path file(Path repository, String artifact, String kind) throws IOException {
    String version = Version.number();
    Path folder = repository.resolve("org/maestro").resolve(artifact).resolve(version);
    return Files.createDirectories(folder).resolve(artifact + "-" + version + "." + kind);
  }

  /** The pom that a jar of ours was built with. */
  private static Optional<JarEntry> descriptor(Path jar) {
    try (JarFile content = new JarFile(jar.toFile())) {
      return content.stream()
          .filter(entry -> entry.getName().startsWith(OURS))
          .filter(entry -> entry.getName().endsWith("/pom.xml"))
          .findFirst();
    } catch (IOException e) {
      return Optional.empty();
    }
  }
}
