package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.MaestroAssertions;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** Devices whose effects come later than their answers, and whose things come and go. */
class LateAndComingTest {
  private static final String SITE = "late";

  @TempDir private Path directory;

  @Test
  void anOvenIsAwaitedUntilItIsHot() throws Exception {
    PythonProcess.assumePython();
    try (Stage stage = Stage.paced(SiteSettings.of(SITE, bob()).build());
        PythonProcess oven = new PythonProcess("oven.py", directory, stage.broker(), SITE)) {
      stage.await("the oven", () -> stage.platform().presentMembers().contains("oven-1"));

      MaestroAssertions.assertThat(stage.goal("(hot oven-1)"))
          .isReached()
          .tells("its effect is awaited, until (hot oven-1)")
          .hasCalls(1);
      assertThat(oven.lines("HEAT")).hasSize(1);
    }
  }

  @Test
  void aDrierIsEndedWhenItsDoorIsOpened() throws Exception {
    PythonProcess.assumePython();
    try (Stage stage = Stage.paced(SiteSettings.of(SITE, bob()).build());
        PythonProcess drier = new PythonProcess("drier.py", directory, stage.broker(), SITE)) {
      stage.await("the drier", () -> stage.platform().presentMembers().contains("drier-1"));

      MaestroAssertions.assertThat(stage.goal("(dry drier-1)"))
          .isNotReached()
          .tells("as it has to hold meanwhile that (shut drier-1), and it did not any more")
          .hasCalls(1);
      assertThat(drier.lines("TUMBLE")).hasSize(1);
      assertThat(drier.lines("STOPPED")).hasSize(1);
    }
  }

  @Test
  void cansAreSoldUntilThereIsNone() throws Exception {
    PythonProcess.assumePython();
    try (Stage stage = Stage.paced(SiteSettings.of(SITE, bob()).build());
        PythonProcess machine = new PythonProcess("stock.py", directory, stage.broker(), SITE)) {
      stage.await(
          "the cans", () -> stage.platform().knowledge().home().individuals().containsKey("can-2"));

      MaestroAssertions.assertThat(stage.goal("(sold can-2 Bob)")).isReached().hasCalls(1);
      MaestroAssertions.assertThat(stage.goal("(exists (?c - Can) (stocked ?c vending-1))"))
          .isReached()
          .hasCalls(0);
      MaestroAssertions.assertThat(stage.goal("(sold can-1 Bob)")).isReached().hasCalls(1);
      MaestroAssertions.assertThat(stage.goal("(exists (?c - Can) (stocked ?c vending-1))"))
          .isNotReached();
      assertThat(machine.lines("SOLD")).containsExactly("SOLD can-2", "SOLD can-1");
      assertThat(machine.lines("EMPTY")).isEmpty();
      assertThat(stage.platform().knowledge().home().individuals()).containsKeys("can-1", "can-2");
    }
  }

  @Test
  void whoSaysThatItHasSoldAndStillHasTheCanHasNotSoldIt() throws Exception {
    PythonProcess.assumePython();
    try (Stage stage = Stage.paced(SiteSettings.of(SITE, bob()).build());
        PythonProcess machine = new PythonProcess("jammed.py", directory, stage.broker(), SITE)) {
      stage.await(
          "the can", () -> stage.platform().knowledge().home().individuals().containsKey("can-1"));

      MaestroAssertions.assertThat(stage.goal("(sold can-1 Bob)"))
          .isNotReached()
          .tells("vending-1 reports that it is done, and its own state says otherwise")
          .hasCalls(1);
      assertThat(machine.lines("JAMMED")).hasSize(1);
    }
  }

  private static Home bob() throws IOException {
    try (InputStream text = LateAndComingTest.class.getResourceAsStream("/homes/bob.ttl")) {
      return new HomeLoader()
          .load(new String(text.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }
}
