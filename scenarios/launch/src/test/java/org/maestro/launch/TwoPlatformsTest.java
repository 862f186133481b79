package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/**
 * Two platforms, each in a process of its own, talk by HTTP: an agent of one asks the other's CCA
 * for a goal, follows it, and hears how it ended (Three-layered architecture, 3.3.1; M67).
 */
@Isolated("its time is wall time, which others beside it would take")
class TwoPlatformsTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final Pattern OTHER = Pattern.compile("--other (\\S+)");

  @TempDir Path directory;

  @Test
  void anAgentOfOneAsksTheOthersCcaForAGoal() throws Exception {
    try (JavaProcess asking = run("asking", "bob");
        JavaProcess asked = run("asked", "bob")) {
      String other = addressOf(asked);
      addressOf(asking);

      JavaProcess.Ended lit = goal("(>= (illuminance zone-b) 72)", other);
      assertThat(lit.exitCode()).as(lit.errors()).isZero();
      assertThat(lit.output()).contains("G1: ", "Reached in ", "lamp-");
      until(() -> asked.output().contains("lamp-"), asked);
      assertThat(asking.output()).doesNotContain("lamp-");

      JavaProcess.Ended unknown = goal("(flies Bob)", other);
      assertThat(unknown.exitCode()).isEqualTo(2);
      assertThat(unknown.errors()).contains("flies");

      JavaProcess.Ended nobody = goal("(in rose zone-a)", other.replace("asked@", "nobody@"));
      assertThat(nobody.exitCode()).isEqualTo(3);
      assertThat(nobody.errors())
          .contains("The agent CCA of the platform nobody cannot be reached at");

      asked.kill();
      JavaProcess.Ended gone = goal("(in rose zone-a)", other);
      assertThat(gone.exitCode()).isEqualTo(3);
      assertThat(gone.errors())
          .contains("The agent CCA of the platform asked cannot be reached at");
    }
  }

  private static String addressOf(JavaProcess platform) {
    until(() -> platform.output().contains("--other "), platform);
    Matcher matcher = OTHER.matcher(platform.output());
    assertThat(matcher.find()).isTrue();
    return matcher.group(1);
  }

  private JavaProcess.Ended goal(String goal, String other) throws Exception {
    try (JavaProcess process = maestro("goal", goal, "--platform", "asking", "--other", other)) {
      return process.await(LIMIT);
    }
  }

  private JavaProcess run(String name, String home) throws IOException {
    return maestro("run", home, "--name", name, "--port", "0", "--mtp", "0", "--speed", "20");
  }

  private JavaProcess maestro(String... arguments) throws IOException {
    return JavaProcess.start(
        "org.maestro.launch.Maestro",
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }

  private static void until(BooleanSupplier condition, JavaProcess process) {
    Awaitility.await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(20))
        .atMost(LIMIT)
        .until(() -> condition.getAsBoolean() || !process.isAlive());
    assertThat(condition.getAsBoolean()).as(process::errors).isTrue();
  }
}
