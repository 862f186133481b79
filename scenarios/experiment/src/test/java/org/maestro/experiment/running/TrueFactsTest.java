package org.maestro.experiment.running;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** Goals are judged by the simulated world, of which the platform has seen nothing here. */
class TrueFactsTest {

  private static String text(String resource) throws IOException {
    try (InputStream stream = TrueFactsTest.class.getResourceAsStream(resource)) {
      return new String(Objects.requireNonNull(stream).readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static TrialSite site() throws IOException {
    Home home =
        new HomeLoader()
            .load(
                text("/homes/bob.ttl")
                    + "\nhome:pause a maestro:Script ; maestro:body \"(wait 1)\" .\n",
                "bob.ttl");
    Scene scene =
        SceneLoader.load(
            "bob-lit",
            new ByteArrayInputStream(text("/scenes/bob-lit.ttl").getBytes(StandardCharsets.UTF_8)),
            home);
    return TrialSite.open(new Trial("truth", home, scene, 1, PhysicalParameters.standard()));
  }

  @Test
  void whatIsSoInTheWorldIsTrueWhoeverKnowsIt() throws IOException {
    try (TrialSite site = site()) {
      assertThat(truth(site, "(in Cup zone-b)")).isEqualTo(Truth.TRUE);
      assertThat(truth(site, "(in Cup ?where)")).isEqualTo(Truth.TRUE);
      assertThat(truth(site, "(in rose zone-b)")).isEqualTo(Truth.TRUE);
      assertThat(truth(site, "(nextTo Cup Bob)")).isEqualTo(Truth.FALSE);
      assertThat(truth(site, "(and (>= (level lamp-a1) 1) (not (nextTo Cup Bob)))"))
          .isEqualTo(Truth.TRUE);
      assertThat(site.truth("(in Cup ?where)", Map.of("where", new Term.Name("zone-a"))))
          .isEqualTo(Truth.FALSE);
      assertThat(truth(site, "(canSee cam-b Cup)")).as("what is seen").isEqualTo(Truth.UNKNOWN);
      assertThat(truth(site, "(pause)")).as("a script").isEqualTo(Truth.UNKNOWN);

      site.world().moveByHand("Cup", new Position(1.1, 2.1, 0));

      assertThat(truth(site, "(nextTo Cup Bob)")).isEqualTo(Truth.TRUE);
    }
  }

  /** Sensors err by 3 %: who asks for as much light as 4 % more would be is not told otherwise. */
  @Test
  void lightThatNoSensorTellsFromEnoughIsEnough() throws IOException {
    try (TrialSite site = site()) {
      double lux = site.world().lux("zone-a");

      assertThat(truth(site, "(>= (illuminance zone-a) %s)".formatted(lux * 1.03)))
          .isEqualTo(Truth.TRUE);
      assertThat(truth(site, "(<= (illuminance zone-a) %s)".formatted(lux * 0.97)))
          .isEqualTo(Truth.TRUE);
      assertThat(truth(site, "(>= (illuminance zone-a) %s)".formatted(lux * 1.06)))
          .isEqualTo(Truth.FALSE);
    }
  }

  private static Truth truth(TrialSite site, String goal) {
    return site.truth(goal, Map.of());
  }
}
