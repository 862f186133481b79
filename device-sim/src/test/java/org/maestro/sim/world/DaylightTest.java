package org.maestro.sim.world;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.protocol.Outcome;
import org.maestro.sim.Homes;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sim.scene.SimulationException;

/** A west room with a window to the south, at the equinox in 50 degrees north. */
class DaylightTest {

  private static final Home HOME =
      new HomeLoader()
          .load(
              """
              @prefix : <https://w3id.org/maestro/domain#> .
              @prefix home: <https://w3id.org/maestro/home/sunny#> .
              @prefix maestro: <https://w3id.org/maestro#> .
              @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
              <https://w3id.org/maestro/home/sunny> a maestro:Home ; rdfs:label "sunny"@en .
              home:west a maestro:Room ; maestro:outline "0 0, 4 0, 4 4, 0 4" ; maestro:height 2.5 .
              home:east a maestro:Room ; maestro:outline "4 0, 8 0, 8 4, 4 4" ; maestro:height 2.5 .
              home:door a maestro:Door ; maestro:openingFrom "4 1" ; maestro:openingTo "4 2" .
              home:south-window a maestro:Window ; maestro:glassFrom "1 0 1" ; maestro:glassTo "3 0 2" .
              home:shutter a :Shutter ; rdfs:label "shutter"@en ; maestro:shades home:south-window .
              """,
              "sunny.ttl");

  private static final String NOON =
      "scene:latitude 50 ; scene:dayOfYear 81 ; scene:solarTime \"12:00\"";

  /** Upon the window at noon: half of 13,227 lux of sky and a tenth of 72,762 from the ground. */
  private static final double CLEAR_DIFFUSE = 13_889.7;

  private static final double CLEAR_SUN = 70_950.9;
  private static final double AROUND = 2 * 0.5 / (72 * 0.5);

  private static Scene scene(String ofSky, double opening) {
    String turtle =
        "@prefix scene: <%s> .\n<https://w3id.org/maestro/home/sunny> %s .\n<#shutter> scene:opening %s ."
            .formatted(SceneLoader.NAMESPACE, ofSky, opening);
    return SceneLoader.load(
        "noon", new ByteArrayInputStream(turtle.getBytes(StandardCharsets.UTF_8)), HOME);
  }

  private static Homes sunny(String ofSky, double opening) {
    return new Homes(HOME, scene(ofSky, opening), 1);
  }

  @Test
  void isTheWindowsLightAndThatOfTheWalls() {
    try (Homes homes = sunny(NOON + " ; scene:cloudCover 1", 1)) {
      // overcast: 13,798.5 lux, of which 39.6 % and a tenth fall upon the window
      double upon = 13_798.5 * 0.496;
      assertThat(homes.world().lux(new Position(2, 2, 0.75)))
          .isCloseTo(upon * 0.78 * (2 * (0.019669 - 0.001058) + AROUND), within(0.2));
      assertThat(homes.world().lux(new Position(2, -1, 0))).isCloseTo(13_798.5, within(1.0));
    }
  }

  @Test
  void theSunShinesUponWhatItReachesThroughTheGlass() {
    try (Homes homes = sunny(NOON, 1)) {
      // at 40 degrees a ray to the floor passes glass of 1 to 2 m height 1.19 to 2.38 m before it
      double straight = 0.78 * 92_620 * 0.642788;
      double shade = homes.world().lux(new Position(2, 2.5, 0));
      double sun = homes.world().lux(new Position(2, 2.3, 0));
      assertThat(sun - shade).isCloseTo(straight, within(0.01 * straight));
      assertThat(homes.world().lux(new Position(2, 1.1, 0))).isLessThan(5_000);
      assertThat(homes.world().lux(new Position(0.9, 2, 0))).isLessThan(5_000);
      // what the sun brings in the walls throw about
      double around = 0.78 * AROUND * (CLEAR_DIFFUSE + CLEAR_SUN);
      assertThat(homes.world().lux(new Position(0.01, 0.01, 0))).isCloseTo(around, within(5.0));
    }
  }

  @Test
  void doesNotPassWallsButDoors() {
    try (Homes homes = sunny(NOON + " ; scene:cloudCover 1", 1)) {
      assertThat(homes.world().lux(new Position(4.5, 1.9, 0))).isPositive();
      assertThat(homes.world().lux(new Position(4.5, 3, 0))).isZero();
      homes.world().setDoor("door", false);
      assertThat(homes.world().lux(new Position(4.5, 1.9, 0))).isZero();
    }
  }

  @Test
  void comesInAsFarAsTheShutterIsOpen() {
    try (Homes homes = sunny(NOON, 0)) {
      Position desk = new Position(2, 2, 0.75);
      assertThat(homes.world().lux(desk)).isZero();
      assertThat(homes.facts("shutter")).contains("(= (opening shutter) 0)");

      var half = homes.call("shutter", "adjustShutter", Map.of("opening", 0.5));
      assertThat(half.result().orElseThrow().outcome()).isEqualTo(Outcome.SUCCEEDED);
      double light = homes.world().lux(desk);
      homes.call("shutter", "adjustShutter", Map.of("opening", 1));
      assertThat(homes.world().lux(desk)).isCloseTo(2 * light, within(0.02 * light));
    }
  }

  @Test
  void isToldByTheShutterWhenItHasChanged() {
    try (Homes homes = sunny(NOON, 0)) {
      double sun = told(homes, "sunlight");
      assertThat(told(homes, "daylight")).isCloseTo(CLEAR_DIFFUSE, within(0.08 * CLEAR_DIFFUSE));
      assertThat(sun).isCloseTo(CLEAR_SUN, within(0.08 * CLEAR_SUN));
      homes.clock.run(Duration.ofMinutes(5));
      assertThat(told(homes, "sunlight")).isEqualTo(sun);
      homes.world().setClouds(1);
      homes.clock.run(Duration.ofMinutes(1));
      assertThat(told(homes, "sunlight")).isZero();
      assertThat(told(homes, "daylight")).isCloseTo(13_798.5 * 0.496, within(600.0));
    }
  }

  /** What is little beside a bright sky is still more than an eye can bear. */
  @Test
  void theFirstSunIsToldHoweverBrightTheSkyIs() {
    try (Homes homes = sunny(NOON + " ; scene:cloudCover 1", 1)) {
      assertThat(told(homes, "sunlight")).isZero();
      homes.world().setClouds(0.993);
      homes.clock.run(Duration.ofMinutes(1));
      assertThat(told(homes, "sunlight")).isBetween(1.0, 0.1 * told(homes, "daylight"));
    }
  }

  private static double told(Homes homes, String word) {
    return homes.facts("shutter").stream()
        .filter(fact -> fact.startsWith("(= (" + word + " shutter) "))
        .mapToDouble(fact -> Double.parseDouble(fact.replaceAll(".* |\\)", "")))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void theCloudsFollowTheRunsSeedUnlessTheSceneHasOne() {
    String clouds = NOON + " ; scene:cloudCover 0.5 ; scene:cloudChange 0.4";
    assertThat(course(clouds, 1)).isEqualTo(course(clouds, 1)).isNotEqualTo(course(clouds, 2));
    String same = clouds + " ; scene:cloudSeed 5";
    assertThat(course(same, 1)).isEqualTo(course(same, 2));
  }

  private static List<Double> course(String ofSky, long seed) {
    try (Homes homes = new Homes(HOME, scene(ofSky, 1), seed)) {
      List<Double> course = new ArrayList<>();
      for (int i = 0; i < 5; i++) {
        homes.clock.run(Duration.ofMinutes(7));
        course.add(homes.world().lux("west"));
      }
      return course;
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "scene:latitude 50 ; scene:dayOfYear 81 | not scene:solarTime",
        "scene:latitude 95 ; scene:dayOfYear 81 ; scene:solarTime '12:00' | between -90",
        "scene:latitude 50 ; scene:dayOfYear 81 ; scene:solarTime 'noon' | such as \"06:30\"",
        "scene:latitude 50 ; scene:weather 'fine' | not scene:dayOfYear",
        "scene:latitude 50 ; scene:dayOfYear 8 ; scene:solarTime '12:00' ; scene:fog 1 | says"
            + " scene:fog"
      })
  void wrongWordsAboutTheSkyAreNamed(String ofSky, String message) {
    assertThatThrownBy(() -> scene(ofSky, 1))
        .isInstanceOf(SimulationException.class)
        .hasMessageContaining(message);
  }
}
