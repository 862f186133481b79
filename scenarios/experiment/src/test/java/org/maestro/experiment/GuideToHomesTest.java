package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.experiment.running.Ending;
import org.maestro.experiment.running.Trial;
import org.maestro.experiment.running.TrialSite;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.home.UnstatedNeeds;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;

/** The home and the scene of docs/guide-homes.md are what the guide says. */
class GuideToHomesTest {
  private static final String NEED = ":minimumIlluminance 72 ; :maximumIlluminance 2000 .";

  private static List<String> examples() throws IOException {
    return Pattern.compile("```turtle\n(.*?)```", Pattern.DOTALL)
        .matcher(Files.readString(Path.of("../../docs/guide-homes.md")))
        .results()
        .map(match -> match.group(1))
        .toList();
  }

  private static Home home(String turtle) {
    return new HomeLoader().load(turtle, "cottage.ttl");
  }

  private static Scene scene(Home home) throws IOException {
    byte[] turtle = examples().get(1).getBytes(StandardCharsets.UTF_8);
    return SceneLoader.load("evening", new ByteArrayInputStream(turtle), home);
  }

  @Test
  void lacksNothing() throws IOException {
    Home home = home(examples().get(0));

    assertThat(UnstatedNeeds.of(home)).isEmpty();
    assertThat(scene(home).of("tim").position()).isPresent();
  }

  @Test
  void whatADeviceLacksIsTold() throws IOException {
    String home = examples().get(0);
    int last = home.lastIndexOf(NEED);

    assertThat(UnstatedNeeds.of(home(home.substring(0, last) + ":maximumIlluminance 2000 .")))
        .singleElement()
        .asString()
        .startsWith("tim offers lookAround, which needs its minimumIlluminance,");
  }

  @Tag("full")
  @Test
  void theBookIsBroughtAsTheGuideTells() throws IOException {
    Home home = home(examples().get(0));
    try (TrialSite site =
        TrialSite.open(new Trial("cottage", home, scene(home), 1, PhysicalParameters.standard()))) {
      Ending ending = site.pursue("(nextTo Book Ada)", Duration.ofMinutes(10));

      assertThat(ending.claimed()).as(ending.explanation()).isTrue();
      assertThat(site.world().isNextTo("Book", "Ada")).isTrue();
      assertThat(ending.story()).anyMatch(entry -> entry.text().contains("tim looks around"));
    }
  }
}
