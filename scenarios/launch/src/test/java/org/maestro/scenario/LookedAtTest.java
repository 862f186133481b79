package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

/** Scripts have things looked at, by whoever can, whatever was known of them before. */
class LookedAtTest {
  private static final Path ASSEMBLED = Path.of("../assembly/src/main/resources");

  private static Stage stage(String name, String body) throws IOException {
    String bob = Files.readString(ASSEMBLED.resolve("homes/bob.ttl"));
    Home home =
        new HomeLoader()
            .load(
                bob + "\nhome:check a maestro:Script ; maestro:body \"%s\" .\n".formatted(body),
                "bob.ttl");
    return Stage.stepped(
        SiteSettings.of("looked-" + name, home)
            .scene(
                SceneLoader.load(
                    "bob-dark",
                    new ByteArrayInputStream(
                        Files.readString(ASSEMBLED.resolve("scenes/bob-dark.ttl"))
                            .getBytes(StandardCharsets.UTF_8)),
                    home))
            .build());
  }

  /** A second look is one, though the first was only a moment ago. */
  @Test
  void whatIsLookedAtIsSeenAnew() throws IOException {
    try (Stage stage = stage("anew", "(seq (look Cup) (wait 5) (look Cup) (look zone-a))")) {
      Pursuit looking = stage.begin("(check)");
      looking.awaitTelling("[1] Seen: (in Cup zone-b).");
      stage.world().moveByHand("Cup", stage.world().position("Bob").orElseThrow());

      assertThat(looking.await())
          .isReached()
          .tells("[3] Look at Cup.")
          .tells("[3] Seen: (in Cup zone-a).")
          .tells("[4] Seen: (= (illuminance zone-a) ");
    }
  }

  @Test
  void whatNobodyFindsIsAReason() throws IOException {
    try (Stage stage =
        stage("gone", "(try (look Cup) (recover (fail \\\"The cup is gone.\\\")))")) {
      stage.world().hide("Cup", true);

      assertThat(stage.goal("(check)"))
          .isNotReached()
          .tells("[1.1] Look at Cup.")
          .tells("Recovers from this: ")
          .tells("The cup is gone.");
    }
  }
}
