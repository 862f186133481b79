package org.maestro.daylight;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;

/**
 * Light on a desk held while the day comes and goes and clouds pass (Three-layered architecture, 1
 * and 5.1; M5, M91).
 */
class HeldByDaylightTest {
  private static final LitDay.Limits ENOUGH = new LitDay.Limits(300, Double.POSITIVE_INFINITY);

  /** The sensor measures every ten seconds; measuring, deciding and dimming come to that. */
  private static final int DETECTED_SECONDS = 12;

  /** The whole way of the shutter. */
  private static final int SHUTTER_SECONDS = 8;

  @Test
  void aMorningsLampsAreDimmedAndReleasedByTheSun() {
    LitDay morning = run(same(), at("06:45", "0.6"), ENOUGH, Duration.ofMinutes(75));

    assertThat(morning.longestDarkSeconds()).isLessThanOrEqualTo(DETECTED_SECONDS);
    assertThat(morning.powers()).contains(0.0).hasSizeGreaterThan(5);
    assertThat(morning.openings()).containsOnly(1.0);
    assertThat(morning.used())
        .isBetween(morning.least(), 1.3 * morning.least())
        .isLessThan(0.4 * morning.alwaysOn());
    assertThat(morning.changes()).isLessThan(40);
  }

  @Test
  void aQuickShutterIsOpenedWhenThatIsCheaperThanLamps() {
    LitDay morning =
        run(
            home ->
                home.replace(
                    "home:shutter a :Shutter ;",
                    "home:shutter a :Shutter ; maestro:offers [ a :adjustShutter ;"
                        + " maestro:cost \"(+ 0.2 (* 0.5 ?opening))\" ] ;"),
            at("06:30", "0.6").andThen(s -> s.replace("opening 1", "opening 0"))::apply,
            ENOUGH,
            Duration.ofMinutes(60));

    assertThat(morning.longestDarkSeconds()).isLessThanOrEqualTo(DETECTED_SECONDS);
    assertThat(morning.openings()).contains(0.0, 1.0);
    assertThat(morning.used()).isBetween(morning.least(), 1.6 * morning.least());
  }

  @Test
  void theShutterIsClosedAgainstGlareAndLampsTakeItsPlace() {
    LitDay noon =
        run(same(), at("11:15", "0.5"), new LitDay.Limits(300, 800), Duration.ofMinutes(60));

    assertThat(noon.longestDarkSeconds()).isLessThanOrEqualTo(DETECTED_SECONDS + SHUTTER_SECONDS);
    assertThat(noon.longestBrightSeconds()).isLessThanOrEqualTo(DETECTED_SECONDS + SHUTTER_SECONDS);
    assertThat(noon.openings()).hasSizeGreaterThan(1);
    assertThat(noon.used()).isLessThan(0.3 * noon.alwaysOn());
  }

  @Test
  @Tag("full")
  void aWholeDayTakesLittleMoreThanTheLeastEnergy() {
    for (long seed = 1; seed <= 3; seed++) {
      LitDay day = run(same(), at("04:30", "0.6"), seed, ENOUGH, Duration.ofHours(16));

      assertThat(day.longestDarkSeconds()).isLessThanOrEqualTo(DETECTED_SECONDS);
      assertThat(day.used())
          .isBetween(day.least(), 1.2 * day.least())
          .isLessThan(0.3 * day.alwaysOn());
    }
  }

  private static UnaryOperator<String> same() {
    return UnaryOperator.identity();
  }

  private static LitDay run(
      UnaryOperator<String> homeChange,
      UnaryOperator<String> sceneChange,
      LitDay.Limits wished,
      Duration hours) {
    return run(homeChange, sceneChange, 1, wished, hours);
  }

  private static UnaryOperator<String> at(String time, String cover) {
    return scene ->
        scene
            .replace("scene:solarTime \"04:30\"", "scene:solarTime \"" + time + "\"")
            .replace("scene:cloudCover 0.6", "scene:cloudCover " + cover);
  }

  private static LitDay run(
      UnaryOperator<String> homeChange,
      UnaryOperator<String> sceneChange,
      long seed,
      LitDay.Limits wished,
      Duration hours) {
    Home home = new HomeLoader().load(homeChange.apply(text("/homes/study.ttl")), "study.ttl");
    String turtle = sceneChange.apply(text("/scenes/study-day.ttl"));
    Scene scene =
        SceneLoader.load(
            "study-day", new ByteArrayInputStream(turtle.getBytes(StandardCharsets.UTF_8)), home);
    return LitDay.of(home, scene, seed, wished, hours);
  }

  private static String text(String path) {
    try (InputStream stream = HeldByDaylightTest.class.getResourceAsStream(path)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
