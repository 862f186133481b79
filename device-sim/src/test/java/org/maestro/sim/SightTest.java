package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Camera;
import org.maestro.hal.Photo;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.ontology.floor.Pose;
import org.maestro.sim.drivers.Actuator;
import org.maestro.sim.drivers.Eye;
import org.maestro.sim.drivers.SimulatedCamera;
import org.maestro.sim.parameters.CameraData;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.world.Likeness;

class SightTest {

  private static final PhysicalParameters PHYSICS = PhysicalParameters.standard();
  private static final Likeness LIKENESS = new Likeness(PHYSICS.camera(), PHYSICS.colour());

  private static Photo noPhoto(Duration now, int widest) {
    throw new AssertionError("nobody asked for a photo");
  }

  private static SimulatedCamera camera(Homes homes, long seed) {
    return camera(homes, seed, LIKENESS);
  }

  private static SimulatedCamera camera(Homes homes, long seed, Likeness likeness) {
    return new SimulatedCamera(
        new Actuator("cam-b", homes.world(), homes.clock, new Random(seed)),
        likeness,
        Eye.fixed(Pose.parse("4.5 1.5 2.8"), 75),
        SightTest::noPhoto);
  }

  private static Camera.Look look(Homes homes, SimulatedCamera camera, int frames) {
    List<Camera.Look> looks = new ArrayList<>();
    camera.look(
        new Target("Cup", Map.of()),
        frames,
        new Camera.Listener() {
          @Override
          public void looked(Camera.Look look) {
            looks.add(look);
          }

          @Override
          public void failed(String reason) {
            throw new AssertionError(reason);
          }
        });
    homes.clock.runUntil(() -> !looks.isEmpty(), Duration.ofSeconds(100));
    return looks.get(0);
  }

  @Test
  void endsAtTheEdgeOfTheConeAndAtWalls() {
    try (Homes homes = Homes.bob("bob-lit")) {
      SimulatedCamera camera = camera(homes, 1);
      // 2.8 m tan 37.5 degrees: 2.1485 m, beyond the walls but for the corners
      assertThat(camera.sees(new Position(4.5, 2.99, 0))).isTrue();
      assertThat(camera.sees(new Position(5.99, 0.01, 0))).isTrue();
      assertThat(camera.sees(new Position(5.99, 0.01, 0.2))).isFalse();
      assertThat(camera.sees(new Position(2.5, 1.0, 0))).isFalse();
      assertThat(camera.sees(new Position(2.7, 2.4, 0))).isTrue();
      homes.world().setDoor("door-ab", false);
      assertThat(camera.sees(new Position(2.7, 2.4, 0))).isFalse();
    }
  }

  @Test
  void isBlindInTheDark() {
    try (Homes homes = Homes.bob("bob-dark")) {
      Camera.Look look = look(homes, camera(homes, 1), 1000);
      assertThat(look.detections()).isZero();
      assertThat(look.position()).isEmpty();
      assertThat(look.areas()).hasSize(1);
      assertThat(look.areas().get(0).area()).isEqualTo("zone-b");
      assertThat(look.areas().get(0).referenceLux()).isCloseTo(17, within(0.5));
    }
  }

  @Test
  void turnsAroundWithWhatCarriesIt() {
    try (Homes homes = Homes.bob("bob-lit")) {
      Actuator onRose = new Actuator("rose", homes.world(), homes.clock, new Random(1));
      SimulatedCamera camera =
          new SimulatedCamera(
              onRose, LIKENESS, Eye.onBoard(onRose, PHYSICS.turn(), 75), SightTest::noPhoto);
      Position rose = homes.world().position("rose").orElseThrow();
      for (double degrees = 0; degrees < 360; degrees += 10) {
        double angle = Math.toRadians(degrees);
        double x = rose.x() + 0.5 * Math.cos(angle);
        assertThat(camera.sees(new Position(x, rose.y() + 0.5 * Math.sin(angle), 0))).isTrue();
      }
      assertThat(camera.sees(new Position(rose.x() + 0.1, rose.y(), 0))).isFalse();
      assertThat(camera.shareInView("zone-b")).isGreaterThan(0.95);
      assertThat(camera.shareInView("zone-a")).isLessThan(0.5);
      double begun = homes.clock.now().toMillis();
      Camera.Look look = look(homes, camera, 15);
      assertThat(look.detections()).isGreaterThan(3);
      assertThat(look.areas()).extracting(Camera.AreaLight::area).containsExactly("zone-b");
      assertThat(homes.clock.now().toMillis() - begun).isBetween(7000.0, 9000.0);
    }
  }

  @Test
  void seesNothingHiddenOrHeld() {
    try (Homes homes = Homes.bob("bob-lit")) {
      SimulatedCamera camera = camera(homes, 1);
      assertThat(look(homes, camera, 15).detections()).isGreaterThan(12);
      homes.world().hide("Cup", true);
      assertThat(look(homes, camera, 15).detections()).isZero();
      homes.world().hide("Cup", false);
      homes.world().whereabouts().put(homes.world().whereabouts().body("Cup").heldBy("rose"));
      assertThat(look(homes, camera, 15).detections()).isZero();
    }
  }

  @Test
  void takesAsManyImagesAndAsLargeOnesAsTheHomeSays() {
    try (Homes homes = new Homes("flat", "flat-day", 1, scene -> scene)) {
      Camera camera = homes.simulated.drivers("cam-living").find(Camera.class).orElseThrow();
      assertThat(camera.frameRate()).isEqualTo(15);
      Photo photo = homes.simulated.photo("cam-living");
      assertThat(List.of(photo.width(), photo.height())).containsExactly(1280, 720);
    }
  }

  @Test
  void aTrustingOneKnowsNoLightThatIsTooMuch() {
    try (Homes homes = Homes.bob("bob-lit")) {
      Camera noticing = camera(homes, 1);
      assertThat(noticing.maximumLux()).isEqualTo(2000);
      assertThat(noticing.detectability(60_000)).isLessThan(1e-6);
      Camera trusting =
          camera(homes, 1, new Likeness(PHYSICS.camera().trusting(), PHYSICS.colour()));
      assertThat(trusting.maximumLux()).isInfinite();
      assertThat(trusting.detectability(60_000)).isGreaterThan(0.98);
      assertThat(trusting.detectability(19)).isLessThan(1e-20);
    }
  }

  @Test
  void isCertainFromItsThresholdOn() {
    CameraData data = PhysicalParameters.standard().camera();
    assertThat(data.detectability(data.minimumLux())).isGreaterThan(0.98);
    assertThat(data.detectability(62.5)).isLessThan(0.001);
    assertThat(data.detectability(19)).isLessThan(1e-20);
    assertThat(data.detectability(data.maximumLux())).isGreaterThan(0.99);
    assertThat(data.detectability(2 * data.maximumLux())).isLessThan(1e-6);
  }

  @Test
  void neverMissesInTenThousandLooksWhereItSaysNotFound() {
    Homes homes = Homes.bob("bob-dark");
    try (homes) {
      Random places = new Random(5);
      homes.world().setAmbient("zone-b", 72.5);
      SimulatedCamera camera = camera(homes, 3);
      double worst = 0;
      for (int trial = 0; trial < 10_000; trial++) {
        homes
            .world()
            .moveByHand(
                "Cup",
                new Position(
                    3.05 + 2.9 * places.nextDouble(), 0.05 + 2.9 * places.nextDouble(), 0));
        Camera.Look look = look(homes, camera, 15);
        assertThat(look.detections()).isGreaterThanOrEqualTo(3);
        worst =
            Math.max(
                worst,
                look.position()
                    .orElseThrow()
                    .distance(homes.world().position("Cup").orElseThrow()));
      }
      assertThat(worst).isBetween(0.05, 0.2);
    }
  }
}
