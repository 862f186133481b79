package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.MaestroAssertions;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/**
 * Vending machines of a stranger, with two cans each, that tell what is left before their results,
 * after them, or never: the last can is sold, and not one more.
 */
class LastCanTest {
  private static final String SITE = "vending";

  @TempDir private Path directory;

  @Test
  void theLastCanIsSoldAndNotOneMore() throws Exception {
    PythonProcess.assumePython();
    try (Stage stage = Stage.paced(SiteSettings.of(SITE, home()).build());
        PythonProcess before = machine(stage, "before");
        PythonProcess after = machine(stage, "after");
        PythonProcess never = machine(stage, "never")) {
      stage.await("the machines", () -> stage.platform().presentMembers().size() == 3);
      for (String way : List.of("before", "after", "never")) {
        String machine = "vending-" + way;
        MaestroAssertions.assertThat(stage.goal("(sold %s Anna)".formatted(machine))).isReached();
        MaestroAssertions.assertThat(stage.goal("(sold %s Ben)".formatted(machine))).isReached();
        MaestroAssertions.assertThat(stage.goal("(sold %s Cleo)".formatted(machine)))
            .isNotReached();
      }
      for (PythonProcess machine : List.of(before, after, never)) {
        assertThat(machine.lines("SOLD")).hasSize(2);
        assertThat(machine.lines("EMPTY")).as("nobody asked it for a third").isEmpty();
      }
    }
  }

  private PythonProcess machine(Stage stage, String way) throws Exception {
    return new PythonProcess("vending.py", directory, stage.broker(), SITE, way);
  }

  private static Home home() throws IOException {
    try (InputStream text = LastCanTest.class.getResourceAsStream("/homes/vending.ttl")) {
      return new HomeLoader()
          .load(new String(text.readAllBytes(), StandardCharsets.UTF_8), "vending.ttl");
    }
  }
}
