package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroAssertions;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** Devices of strangers, in a language and a process of their own, that answer in odd ways. */
class OddDevicesTest {
  private static final String SITE = "odd";

  @TempDir private Path directory;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          text|kilograms has to be a number, and is "heavy"
          nan|kilograms has to be a number, and is "NaN"
          null|kilograms is missing
          missing|kilograms is missing
          """)
  void whoTellsRubbishIsCalledThreeTimes(String way, String named) throws Exception {
    try (Stage stage = stage();
        PythonProcess odd = odd(stage, way)) {
      stage.await("the odd one", () -> stage.platform().presentMembers().contains("odd-1"));
      GoalOutcome outcome = stage.goal("(>= (weight Box) 3)");
      MaestroAssertions.assertThat(outcome).isNotReached().tells(named);
      stage.goal("(>= (weight Box) 3)");
      assertThat(odd.lines("WEIGH")).hasSize(3);
    }
  }

  /** It says nothing for longer than it is waited for, and then that it is done. */
  @Test
  @Tag("full")
  void whoIsSlowIsAskedAgainAndDoesItOnce() throws Exception {
    isDoneOnce("slow", "28");
  }

  @Test
  @Tag("full")
  void whoSaysThatItIsAtItIsWaitedFor() throws Exception {
    isDoneOnce("busy", "50");
  }

  /** Twice it says nothing, so another does it; it may be at it still, and hears that it is not. */
  @Test
  @Tag("full")
  void whoIsPassedOverIsToldToEndIt() throws Exception {
    try (Stage stage = stage();
        PythonProcess mute = odd(stage, "slow", "600");
        PythonProcess other = odd(stage, "slow", "0", "odd-2", "5")) {
      stage.await("both", () -> stage.platform().presentMembers().size() == 2);
      GoalOutcome outcome = stage.goal("(bright Box)");
      MaestroAssertions.assertThat(outcome)
          .isReached()
          .tells("odd-1 has not said what became of it, and is told to end it");
      assertThat(other.lines("POLISH")).hasSize(1);
      String begun = mute.lines("POLISH").get(0).replace("POLISH", "CANCEL");
      stage.await("its being told", () -> mute.lines("CANCEL").contains(begun));
      assertThat(mute.lines("POLISH")).hasSize(1);
    }
  }

  private void isDoneOnce(String... way) throws Exception {
    try (Stage stage = stage();
        PythonProcess odd = odd(stage, way)) {
      stage.await("the odd one", () -> stage.platform().presentMembers().contains("odd-1"));
      GoalOutcome outcome = stage.goal("(bright Box)");
      MaestroAssertions.assertThat(outcome).isReached().hasCalls(1);
      assertThat(odd.lines("POLISH")).hasSize(1);
    }
  }

  private static Stage stage() throws IOException, InterruptedException {
    PythonProcess.assumePython();
    return Stage.paced(SiteSettings.of(SITE, home()).build());
  }

  private static Home home() throws IOException {
    try (InputStream text = OddDevicesTest.class.getResourceAsStream("/homes/odd.ttl")) {
      return new HomeLoader()
          .load(new String(text.readAllBytes(), StandardCharsets.UTF_8), "odd.ttl");
    }
  }

  private PythonProcess odd(Stage stage, String... way) throws Exception {
    return new PythonProcess("odd.py", directory, stage.broker(), SITE, way);
  }
}
