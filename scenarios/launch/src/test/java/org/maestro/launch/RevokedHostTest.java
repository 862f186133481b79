package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** The process of the lamps' agents is taken out of its site while all runs. */
@Isolated("its time is wall time, which others beside it would take")
@Tag("full")
class RevokedHostTest {
  private static final Duration LIMIT = Duration.ofSeconds(120);
  private static final Pattern PORT = Pattern.compile("JADE on port (\\d+)");

  @TempDir private Path directory;

  private JavaProcess maestro(String... arguments) throws IOException {
    Path runtime = Files.createDirectories(directory.resolve("runtime"));
    Files.setPosixFilePermissions(runtime, PosixFilePermissions.fromString("rwx------"));
    return JavaProcess.startLogging(
        "org.maestro.launch.Maestro",
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", runtime.toString()));
  }

  private JavaProcess.Ended done(String... arguments) throws Exception {
    try (JavaProcess process = maestro(arguments)) {
      return process.await(LIMIT);
    }
  }

  @Test
  void itsAgentsHaveAPlaceAgain() throws Exception {
    revoke(false);
  }

  /** They were taken over before, and call under its name. */
  @Test
  void itsAgentsThatHadOneAlreadyCallUnderAnotherName() throws Exception {
    revoke(true);
  }

  private void revoke(boolean dead) throws Exception {
    String site = directory.resolve("site").toString();
    assertThat(done("secure", site, "bob").exitCode()).isZero();
    try (JavaProcess platform =
        maestro("run", "bob", "--security", site, "--port", "0", "--speed", "10")) {
      Awaitility.await().atMost(LIMIT).until(() -> PORT.matcher(platform.output()).find());
      Matcher port = PORT.matcher(platform.output());
      assertThat(port.find()).isTrue();
      String main = "127.0.0.1:" + port.group(1);
      try (JavaProcess lights =
          maestro("container", "--main", main, "--name", "lights", "--security", site)) {
        Awaitility.await()
            .atMost(LIMIT)
            .until(() -> lights.output().contains("The container lights runs here"));

        if (dead) {
          lights.kill();
          awaitAgentsHere(site);
          reach("(>= (illuminance zone-b) 60)", site, platform);
        }
        JavaProcess.Ended revoked = done("secure", site, "--revoke", "container-lights");
        assertThat(revoked.exitCode()).as(revoked.errors()).isZero();
        awaitAgentsHere(site);

        reach("(>= (illuminance zone-b) 75)", site, platform);
      }
    }
  }

  private void reach(String goal, String site, JavaProcess platform) throws Exception {
    JavaProcess.Ended ended = done("goal", goal, "--security", site);
    assertThat(ended.exitCode()).as(ended.output() + platform.errors()).isZero();
  }

  private void awaitAgentsHere(String site) {
    Awaitility.await()
        .atMost(LIMIT)
        .until(() -> done("agents", "--security", site).output(), RevokedHostTest::areHere);
  }

  /** All lamps' agents live in the platform's own process. */
  private static boolean areHere(String agents) {
    List<String> lamps = agents.lines().filter(line -> line.contains("lamp-")).toList();
    return !lamps.isEmpty() && lamps.stream().noneMatch(line -> line.contains("(other process)"));
  }
}
