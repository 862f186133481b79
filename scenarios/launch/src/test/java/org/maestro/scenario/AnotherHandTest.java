package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.experiment.running.Ending;
import org.maestro.experiment.running.Trial;
import org.maestro.experiment.running.TrialSite;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.SceneLoader;

/**
 * The cup has become a saucer, which a gripper's bag cannot wrap (Three-layered architecture, 4.1;
 * M80), or a mug that is too wide.
 */
class AnotherHandTest {
  private static final String SAUCER = "\"0.06 0.06 0.008\"";
  private static final String MUG = "\"0.12 0.12 0.1\"";
  private static final String TIM = ":colour \"green\" ; :size \"0.58 0.38 0.4\"";
  private static final String TOO_FLAT = "it is too flat for the bag to get around it";

  @Test
  void whatABagCannotWrapARobotWithFingersBrings() {
    try (TrialSite site =
        site(
            Map.of(
                "\"0.08 0.08 0.1\"",
                SAUCER,
                "home:tim a :MobileRobot ; maestro:driver \"mecanum-robot\" ;",
                "home:tim a :MobileRobot ; maestro:driver \"mobile-robot-with-fingers\" ;"))) {
      Ending ending = site.pursue("(nextTo Cup Bob)", Duration.ofMinutes(10));

      assertThat(told(ending)).contains("rose picks up Cup", TOO_FLAT, "tim picks up Cup");
      assertThat(ending.claimed()).as(told(ending)).isTrue();
      assertThat(site.world().isNextTo("Cup", "Bob")).isTrue();
    }
  }

  @Test
  void whatNobodyCanHoldIsNotBroughtForThatReason() {
    try (TrialSite site = site(Map.of("\"0.08 0.08 0.1\"", SAUCER))) {
      Ending ending = site.pursue("(nextTo Cup Bob)", Duration.ofMinutes(10));

      assertThat(ending.claimed()).isFalse();
      assertThat(ending.explanation()).contains(TOO_FLAT);
    }
  }

  @Test
  void whatIsTooWideForAllIsNotReachedFor() {
    try (TrialSite site = site(Map.of("\"0.08 0.08 0.1\"", MUG))) {
      Ending ending = site.pursue("(nextTo Cup Bob)", Duration.ofMinutes(10));

      assertThat(ending.claimed()).isFalse();
      assertThat(told(ending)).doesNotContainPattern("Step [0-9]+ of [0-9]+: (rose|tim) ");
      assertThat(ending.explanation())
          .contains("The width of Cup has to be at most the gripper opening of")
          .contains("(0.098 m)")
          .contains("it is 0.12 m");
    }
  }

  /** Tim is the dearer one, as the test before shows: rose is asked first. */
  @Test
  void whatIsTooWideForOneTheOtherBrings() {
    try (TrialSite site =
        site(
            Map.of(
                "\"0.08 0.08 0.1\"",
                MUG,
                TIM + " ; :speed 0.8 ; :payload 0.5 ; :gripperOpening 0.098",
                TIM + " ; :speed 0.8 ; :payload 0.5 ; :gripperOpening 0.14"))) {
      Ending ending = site.pursue("(nextTo Cup Bob)", Duration.ofMinutes(10));

      assertThat(told(ending)).doesNotContain("rose picks up Cup").contains("tim picks up Cup");
      assertThat(ending.claimed()).as(told(ending)).isTrue();
      assertThat(site.world().isNextTo("Cup", "Bob")).isTrue();
    }
  }

  /** Nobody said what the cup weighs: that alone makes nothing impossible. */
  @Test
  void whatNobodyStatesTheMassOfIsTried() {
    try (TrialSite site = site(Map.of(" ; :mass 0.25", ""))) {
      Ending ending = site.pursue("(nextTo Cup Bob)", Duration.ofMinutes(10));

      assertThat(ending.claimed()).as(told(ending)).isTrue();
      assertThat(site.world().isNextTo("Cup", "Bob")).isTrue();
    }
  }

  private static TrialSite site(Map<String, String> changes) {
    String text = text("homes/bob-two-robots.ttl");
    for (Map.Entry<String, String> change : changes.entrySet()) {
      assertThat(text).contains(change.getKey());
      text = text.replace(change.getKey(), change.getValue());
    }
    Home home = new HomeLoader().load(text, "bob-two-robots.ttl");
    return TrialSite.open(
        new Trial(
            "saucer",
            home,
            SceneLoader.load("bob-two-robots", open("scenes/bob-two-robots.ttl"), home),
            1,
            PhysicalParameters.standard()));
  }

  private static String text(String resource) {
    try (InputStream stream = open(resource)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static InputStream open(String resource) {
    return AnotherHandTest.class.getClassLoader().getResourceAsStream(resource);
  }

  private static String told(Ending ending) {
    return String.join("\n", ending.story().stream().map(entry -> entry.text()).toList());
  }
}
