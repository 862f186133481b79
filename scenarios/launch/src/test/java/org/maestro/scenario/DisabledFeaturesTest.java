package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.AgentRow;
import org.maestro.sim.scene.SceneLoader;

/**
 * Features that the present state of a member does not allow, as the platform shows them
 * (Three-layered architecture, 3.2.1; M33).
 */
class DisabledFeaturesTest {
  private static final String MUG =
      """

      home:Mug a :Item ; rdfs:label "the mug" ; :colour "green" ; :size "0.08 0.08 0.1" ; :mass 0.25 .
      """;
  private static final String WHERE_IT_STANDS =
      """

      <#Mug> scene:position "5.2 1.4 0" ; scene:radius 0.04 ; scene:mass 0.25 .
      """;

  /** What is disabled now may be done later in a plan. */
  @Test
  void aCarryingRobotShowsPickDisabledAndAPlanPicksUpAllTheSameAfterPlacing() {
    try (Stage stage = Stage.stepped(site())) {
      assertThat(disabled(stage)).as("with an empty hand").containsExactly("place");

      assertThat(stage.goal("(in Cup rose)")).isReached();
      assertThat(disabled(stage)).as("carrying").containsExactly("pick");

      assertThat(stage.goal("(in Mug rose)")).isReached().hasReplansAtMost(2);
      assertThat(stage.world().holder("Mug")).contains("rose");
      assertThat(stage.world().holder("Cup")).isEmpty();
      assertThat(disabled(stage)).as("carrying the other").containsExactly("pick");

      assertThat(stage.goal("(nextTo Mug Bob)")).isReached();
      assertThat(disabled(stage)).as("with an empty hand again").containsExactly("place");
    }
  }

  private static List<String> disabled(Stage stage) {
    return stage.platform().agents().stream()
        .filter(row -> row.agent().equals("rose"))
        .map(AgentRow::disabled)
        .findFirst()
        .orElseThrow();
  }

  private static SiteSettings site() {
    Home home = new HomeLoader().load(text("/homes/bob.ttl") + MUG, "bob.ttl");
    String scene = text("/scenes/bob-lit.ttl") + WHERE_IT_STANDS;
    return SiteSettings.of("disabled", home)
        .scene(
            SceneLoader.load(
                "the scene",
                new ByteArrayInputStream(scene.getBytes(StandardCharsets.UTF_8)),
                home))
        .build();
  }

  private static String text(String path) {
    try (InputStream stream = DisabledFeaturesTest.class.getResourceAsStream(path)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
