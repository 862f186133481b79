package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Somebody else's project, as docs/guide-scenarios.md shows it and {@code ./maestro new scenario}
 * writes it: built by Maven from the installed artifacts, with nothing else of ours on its path.
 */
class OutsideProjectTest {
  private static final Duration LIMIT = Duration.ofMinutes(4);
  private static final Path GUIDE = Path.of("..", "..", "docs", "guide-scenarios.md");
  private static final Pattern LISTING = Pattern.compile("(?s)```(\\w*)\n(.*?)```");
  private static final Pattern CLASS = Pattern.compile("(?m)^class (\\w+)");

  @TempDir private Path directory;

  @Test
  @Tag("full")
  void theProjectOfTheGuidePassesWithTheInstalledArtifactsAlone() throws Exception {
    Path project = directory.resolve("project");
    write(project);
    assertThat(Files.readString(project.resolve("pom.xml"))).isEqualTo(shown("xml").get(0));
    Path tests = project.resolve("src/test/java");
    assertThat(Files.readString(tests.resolve("CupTest.java"))).isEqualTo(shown("java").get(0));
    for (String listing : shown("java")) {
      Files.writeString(tests.resolve(nameOf(listing) + ".java"), listing);
    }

    try (ArtifactsInstalled installed = ArtifactsInstalled.in(directory.resolve("repository"))) {
      String said = build(project, installed.repository());

      assertThat(said).contains("Tests run: 4, Failures: 1, Errors: 0, Skipped: 0");
      assertThat(report(project, "RedTest.txt")).contains(shown("").get(1).split("\\.\\.\\.\n"));
      assertNothingElseOfOurs(classPath(project), project, installed.repository());
    }
  }

  private static void assertNothingElseOfOurs(List<Path> classPath, Path project, Path repository) {
    assertThat(classPath)
        .allMatch(entry -> entry.startsWith(project) || entry.startsWith(repository))
        .filteredOn(entry -> entry.startsWith(repository.resolve("org/maestro")))
        .extracting(entry -> entry.getParent().getParent().getFileName().toString())
        .containsExactlyInAnyOrder(
            "ontology",
            "rats-bridge",
            "device-sim",
            "maestro-core",
            "maestro-assembly",
            "maestro-junit");
  }

  /** The project, and the home that the guide has beside it. */
  private void write(Path project) throws IOException {
    maestro("new", "scenario", project.toString());
    Path home = directory.resolve("home");
    maestro("new", "home", home.toString());
    Path resources = project.resolve("src/test/resources");
    Files.createDirectories(resources.resolve("homes"));
    Files.createDirectories(resources.resolve("scenes"));
    Files.copy(home.resolve("home.ttl"), resources.resolve("homes/cottage.ttl"));
    Files.copy(home.resolve("scene.ttl"), resources.resolve("scenes/evening.ttl"));
  }

  /** What Maven says; it ends well, as what is red stands in the reports. */
  private String build(Path project, Path repository) throws Exception {
    Path output = directory.resolve("output");
    Process maven =
        new ProcessBuilder(
                Path.of(System.getProperty("maestro.maven"), "bin", "mvn").toString(),
                "-B",
                "-ntp",
                "-Dmaven.repo.local=" + repository,
                "-Dmaven.test.failure.ignore",
                "-DtrimStackTrace=false",
                "-DargLine=-Xmx512m -XX:TieredStopAtLevel=1 -XX:+UseSerialGC",
                "test")
            .directory(project.toFile())
            .redirectErrorStream(true)
            .redirectOutput(output.toFile())
            .start();
    try {
      boolean ended = maven.waitFor(LIMIT.toMillis(), TimeUnit.MILLISECONDS);
      String said = Files.readString(output);
      assertThat(ended).as(said).isTrue();
      assertThat(maven.exitValue()).as(said).isZero();
      return said;
    } finally {
      maven.descendants().forEach(ProcessHandle::destroyForcibly);
      maven.destroyForcibly().onExit().join();
    }
  }

  /** On which its tests ran. */
  private static List<Path> classPath(Path project) throws IOException {
    MatchResult path =
        Pattern.compile("name=\"(?:surefire.test.class.path|java.class.path)\" value=\"([^\"]*)\"")
            .matcher(report(project, "TEST-CupTest.xml"))
            .results()
            .findFirst()
            .orElseThrow();
    return Arrays.stream(path.group(1).split(File.pathSeparator)).map(Path::of).toList();
  }

  private static String report(Path project, String name) throws IOException {
    return Files.readString(project.resolve("target/surefire-reports").resolve(name));
  }

  private static String nameOf(String listing) {
    return CLASS.matcher(listing).results().findFirst().orElseThrow().group(1);
  }

  /** The guide's listings in that language. */
  private static List<String> shown(String language) throws IOException {
    return LISTING
        .matcher(Files.readString(GUIDE))
        .results()
        .filter(listing -> listing.group(1).equals(language))
        .map(listing -> listing.group(2))
        .toList();
  }

  private static void maestro(String... arguments) {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
    assertThat(Maestro.commandLine(stream, stream).execute(arguments))
        .as(said.toString(StandardCharsets.UTF_8))
        .isZero();
  }
}
