package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

/**
 * No word of a domain means anything to the platform: with other words for all classes, predicates,
 * features and devices, the same job makes the same story in the other words.
 */
class RenamingTest {

  private static final Set<String> DEVICE_CLASSES =
      Set.of("Camera", "Lamp", "LightSensor", "MobileRobot");

  private static final String VOCABULARY = HomeLoader.shippedVocabulary();
  private static final String HOME = resource("/homes/bob.ttl");

  @ParameterizedTest
  @CsvSource({
    "1, bob-dark, (nextTo Cup Bob)",
    "2, bob-dark, (nextTo Cup Bob)",
    "3, bob-weak-lamps, (nextTo Cup Bob)",
    "4, bob-hidden, (nextTo Cup Bob)",
    "5, bob-dark, (canSee ?agent Cup)",
    "6, bob-lit, (>= (illuminance zone-b) 5000)"
  })
  void otherWordsMakeTheSameStory(long seed, String sceneName, String goal) {
    Renaming renaming = Renaming.of(VOCABULARY, HOME, DEVICE_CLASSES, seed);
    String scene = resource("/scenes/" + sceneName + ".ttl");
    assertThat(renaming.words()).hasSizeGreaterThan(50).contains("rose", "in", "pick", "Camera");

    GoalOutcome usual = run("usual", VOCABULARY, HOME, scene, goal);
    GoalOutcome renamed =
        run(
            "renamed",
            renaming.turtle(VOCABULARY),
            renaming.turtle(HOME),
            renaming.turtle(scene),
            renaming.formula(goal));

    assertThat(renamed.storyText().split("[^\\w-]+")).doesNotContain("lamp-b1", "rose", "pick");
    assertThat(renaming.undone(renamed.storyText())).isEqualTo(usual.storyText());
    assertThat(renamed.reached()).isEqualTo(usual.reached());
    assertThat(renamed.calls()).isEqualTo(usual.calls());
    assertThat(renamed.replans()).isEqualTo(usual.replans());
  }

  private static GoalOutcome run(
      String name, String vocabulary, String homeText, String scene, String goal) {
    Home home = HomeLoader.withVocabulary(List.of(vocabulary)).load(homeText, "bob.ttl");
    SiteSettings site =
        SiteSettings.of(name, home)
            .scene(
                SceneLoader.load(
                    "the scene",
                    new ByteArrayInputStream(scene.getBytes(StandardCharsets.UTF_8)),
                    home))
            .build();
    try (Stage stage = Stage.stepped(site)) {
      return stage.goal(goal);
    }
  }

  private static String resource(String path) {
    try (InputStream stream = RenamingTest.class.getResourceAsStream(path)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(path + " cannot be read.", e);
    }
  }
}
