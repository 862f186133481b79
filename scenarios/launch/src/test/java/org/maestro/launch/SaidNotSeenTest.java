package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** Who asks at the command line is told whether somebody has seen it, or only its doer says so. */
@Isolated("its time is wall time, which others beside it would take")
class SaidNotSeenTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);

  @TempDir Path directory;

  @Test
  void whatOnlyItsDoerSaysIsNoPlainSuccess() throws Exception {
    try (JavaProcess platform =
        maestro("run", "bob", "--port", "0", "--mtp", "0", "--speed", "20")) {
      Awaitility.await()
          .atMost(LIMIT)
          .until(() -> platform.output().contains("--other ") || !platform.isAlive());

      JavaProcess.Ended said = goal("(>= (level lamp-b1) 0.25)");
      assertThat(said.exitCode()).as(said.output() + said.errors()).isEqualTo(4);
      assertThat(said.output())
          .contains(
              "Reached, but not confirmed, in ",
              "It is done, as far as lamp-b1 says; nobody can confirm it.");

      JavaProcess.Ended again = goal("(>= (level lamp-b1) 0.25)", "--json");
      assertThat(again.exitCode()).isEqualTo(4);
      assertThat(again.output()).contains("\"reached\":true", "\"confirmed\":false");

      JavaProcess.Ended seen = goal("(>= (illuminance zone-a) 10)", "--json");
      assertThat(seen.exitCode()).as(seen.output() + seen.errors()).isZero();
      assertThat(seen.output()).contains("\"reached\":true", "\"confirmed\":true");
    }
  }

  private JavaProcess.Ended goal(String goal, String... options) throws Exception {
    List<String> arguments = new ArrayList<>(List.of("goal", goal));
    arguments.addAll(List.of(options));
    try (JavaProcess process = maestro(arguments.toArray(String[]::new))) {
      return process.await(LIMIT);
    }
  }

  private JavaProcess maestro(String... arguments) throws IOException {
    return JavaProcess.start(
        "org.maestro.launch.Maestro",
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }
}
