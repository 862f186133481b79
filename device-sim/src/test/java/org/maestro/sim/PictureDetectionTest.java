package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Camera;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.parameters.PhysicalParameters;

/** What cameras find in the pictures that they take (checklist M81). */
class PictureDetectionTest {
  private static final int FRAMES = 10;

  /** What a look came to: the findings, or why there are none. */
  private record Outcome(Camera.Look look, String failure) {}

  private static PhysicalParameters fromPixels(PhysicalParameters usual) {
    return usual.with(Map.of("world.camera.fromPixels", "true"));
  }

  private static Homes homes(String home, String scene) {
    Home loaded = Homes.home(home);
    return new Homes(loaded, Homes.scene(scene, loaded), 1, PictureDetectionTest::fromPixels);
  }

  private static Outcome look(Homes homes, String camera, String thing) {
    return look(homes, camera, new Target(thing, Map.of()));
  }

  private static Outcome look(Homes homes, String camera, Target target) {
    AtomicReference<Outcome> outcome = new AtomicReference<>();
    Camera eye = homes.simulated.drivers(camera).find(Camera.class).orElseThrow();
    homes.clock.schedule(
        Duration.ZERO,
        camera,
        () ->
            eye.look(
                target,
                FRAMES,
                new Camera.Listener() {
                  @Override
                  public void looked(Camera.Look look) {
                    outcome.set(new Outcome(look, ""));
                  }

                  @Override
                  public void failed(String reason) {
                    outcome.set(new Outcome(null, reason));
                  }
                }));
    homes.clock.run(Duration.ofSeconds(1));
    return outcome.get();
  }

  private static void light(Homes homes, double lux) {
    homes
        .world()
        .building()
        .map()
        .areas()
        .forEach(area -> homes.world().setAmbient(area.name(), lux));
  }

  private static void put(Homes homes, String thing, double x, double y) {
    homes.world().moveByHand(thing, new Position(x, y, 0));
  }

  private static void assertFound(Homes homes, String camera, String thing) {
    Outcome outcome = look(homes, camera, thing);
    Position truth = homes.world().position(thing).orElseThrow();
    assertThat(outcome.failure()).isEmpty();
    assertThat(outcome.look().detections()).as(thing).isEqualTo(FRAMES);
    Position seen = outcome.look().position().orElseThrow();
    assertThat(seen.distance(truth)).as(thing).isLessThan(0.06);
  }

  private static int detections(Homes homes, String camera, String thing) {
    Outcome outcome = look(homes, camera, thing);
    assertThat(outcome.failure()).isEmpty();
    return outcome.look().detections();
  }

  @Test
  void thingsPersonsAndRobotsAreFoundWhereTheyAre() {
    try (Homes homes = homes("bob", "bob-lit")) {
      assertFound(homes, "cam-b", "Cup");
      assertFound(homes, "cam-a", "Bob");
      assertFound(homes, "cam-b", "rose");
      assertThat(detections(homes, "cam-a", "Cup")).isZero();
    }
  }

  @Test
  void whatIsInAHandOrInACupboardIsNotFound() {
    try (Homes homes = homes("bob", "bob-hidden")) {
      assertThat(detections(homes, "cam-b", "Cup")).isZero();
    }
  }

  @Test
  void tooLittleLightAndTooMuchLeaveNothingOfIt() {
    try (Homes homes = homes("arena", "arena-light")) {
      light(homes, 0.3);
      assertThat(detections(homes, "cam-2", "GreenObject")).isZero();
      light(homes, 20);
      assertThat(detections(homes, "cam-2", "GreenObject")).isEqualTo(FRAMES);
      light(homes, 50_000);
      assertThat(detections(homes, "cam-2", "GreenObject")).isZero();
    }
  }

  @Test
  void whatSomebodyStandsBeforeIsNotSeen() {
    try (Homes homes = homes("arena", "arena-light")) {
      light(homes, 100);
      assertFound(homes, "cam-2", "GreenObject");
      Position there = homes.world().position("GreenObject").orElseThrow();
      put(homes, "rose", there.x(), there.y());
      assertThat(look(homes, "cam-2", "GreenObject").failure())
          .isEqualTo("Something stands where GreenObject was seen last, and may hide it.");
      put(homes, "rose", 7.4, 2.2);
      put(homes, "GreenObject", 0.2, 0.2);
      assertThat(detections(homes, "cam-3", "GreenObject")).isZero();
    }
  }

  @Test
  void ofTwoThatLookAlikeThePlaceTellsWhichItIs() {
    try (Homes homes = homes("arena", "arena-light")) {
      light(homes, 100);
      assertFound(homes, "cam-2", "RedObject1");
      assertFound(homes, "cam-2", "RedObject2");
      put(homes, "RedObject1", 4.2, 0.6);
      assertFound(homes, "cam-2", "RedObject1");
      assertFound(homes, "cam-2", "RedObject2");
      put(homes, "RedObject1", 3.5, 0.7);
      put(homes, "RedObject2", 5, 0.7);
      assertThat(look(homes, "cam-2", "RedObject1").failure())
          .isEqualTo(
              "What is in view may be RedObject1 as well as RedObject2: they look alike, and it is not known where the other is now.");
    }
  }

  @Test
  void ofTwoOfOneColourTheSizeTellsWhichItIs() {
    Home home =
        new HomeLoader()
            .load(
                Homes.text("arena")
                    .replace(
                        "\"the second red object\"@en ; :colour \"red\" ; :size \"0.06 0.06 0.06\"",
                        "\"the second red object\"@en ; :colour \"red\" ; :size \"0.14 0.14 0.12\""),
                "arena.ttl");
    try (Homes homes =
        new Homes(home, Homes.scene("arena-light", home), 1, PictureDetectionTest::fromPixels)) {
      light(homes, 100);
      for (double x : List.of(3.6, 4.4, 5.0)) {
        put(homes, "RedObject1", x, 0.7);
        put(homes, "RedObject2", x, 2.2);
        assertFound(homes, "cam-2", "RedObject1");
        assertFound(homes, "cam-2", "RedObject2");
      }
    }
  }

  @Test
  void ofWhatNobodyKnowsTheLooksOfNothingIsSaid() {
    try (Homes homes = homes("arena", "arena-light")) {
      assertThat(look(homes, "cam-2", "Umbrella").failure())
          .isEqualTo("It is not known what Umbrella looks like: state its colour in the home.");
    }
  }

  /** The noise of pictures is that of the data sheet. */
  @Test
  void picturesGetGrainyWhereLightIsScarce() {
    try (Homes homes = homes("arena", "arena-light")) {
      light(homes, 1000);
      double bright = grain(homes);
      light(homes, 4);
      double dark = grain(homes);

      assertThat(dark).isGreaterThan(2 * bright);
    }
  }

  /** Standard deviation between neighbours on the floor in the picture's middle. */
  private static double grain(Homes homes) {
    var photo = homes.simulated.photo("cam-2");
    double squares = 0;
    int pairs = 0;
    for (int column = 900; column < 1000; column++) {
      double left = photo.at(column, 300) >> 8 & 0xff;
      double right = photo.at(column + 1, 300) >> 8 & 0xff;
      squares += (left - right) * (left - right) / 2;
      pairs++;
    }
    return Math.sqrt(squares / pairs);
  }

  /** A description may come with the call, as lists over the bus, and outweighs the home's. */
  @Test
  void whatACallSaysOfItsLooksCounts() {
    try (Homes homes = homes("arena", "arena-light")) {
      light(homes, 100);
      Map<String, Object> blue = Map.of("colour", "blue", "size", List.of(0.06, 0.06, 0.06));
      Map<String, Object> green = Map.of("colour", "green", "size", List.of(0.06, 0.06, 0.06));

      assertThat(look(homes, "cam-2", new Target("GreenObject", green)).look().detections())
          .isEqualTo(FRAMES);
      assertThat(look(homes, "cam-2", new Target("RedObject1", blue)).look().detections()).isZero();
    }
  }

  @Test
  void whatIsTooSmallForItsPicturesIsNotSaidToBeElsewhere() {
    Home home = Homes.home("arena");
    try (Homes homes =
        new Homes(
            home,
            Homes.scene("arena-light", home),
            1,
            usual -> fromPixels(usual).with(Map.of("world.camera.detectionWidth", "64")))) {
      light(homes, 100);
      assertThat(look(homes, "cam-2", "GreenObject").failure())
          .isEqualTo("GreenObject is too small for this camera: its pictures hardly show it.");
    }
  }
}
