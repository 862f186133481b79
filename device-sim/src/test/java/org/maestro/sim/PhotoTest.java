package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Camera;
import org.maestro.hal.Photo;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;

/** Pictures that ceiling cameras take of the arena: small ones, for speed. */
class PhotoTest {

  private static final int WIDTH = 320;
  private static final int HEIGHT = 180;

  private static Homes arena(double ambientLux, long seed) {
    Home home = Homes.home("arena");
    Scene scene = Homes.scene("arena-dark", home);
    Homes homes = new Homes(home, scene, seed, PhotoTest::small);
    homes.world().setAmbient("zone-1", ambientLux);
    return homes;
  }

  private static PhysicalParameters small(PhysicalParameters usual) {
    return usual.with(
        Map.of(
            "world.camera.width",
            String.valueOf(WIDTH),
            "world.camera.height",
            String.valueOf(HEIGHT)));
  }

  /** Where a camera above x 1.4 and y 1.5 in 2.8 m height shows a point of the floor. */
  private static int at(Photo photo, double x, double y) {
    double scale = HEIGHT / (2 * 2.8 * Math.tan(Math.toRadians(37.5)));
    int column = (int) Math.round(WIDTH / 2.0 + (x - 1.4) * scale);
    int row = (int) Math.round(HEIGHT / 2.0 - (y - 1.5) * scale);
    return photo.at(column, row);
  }

  private static int red(int rgb) {
    return rgb >> 16;
  }

  private static int green(int rgb) {
    return rgb >> 8 & 0xff;
  }

  @Test
  void showsThingsWhereTheyAreInTheirColour() {
    try (Homes homes = arena(300, 1)) {
      homes.world().moveByHand("RedObject1", new Position(0.6, 1.0, 0));
      Photo photo = homes.simulated.photo("cam-1");
      assertThat(photo.width()).isEqualTo(WIDTH);
      int greenObject = at(photo, 1.2, 2.0);
      assertThat(green(greenObject)).isGreaterThan(2 * red(greenObject));
      int redObject = at(photo, 0.6, 1.0);
      assertThat(red(redObject)).isGreaterThan(2 * green(redObject));
      int floor = at(photo, 2.2, 1.2);
      assertThat(Math.abs(red(floor) - green(floor))).isLessThan(40);
    }
  }

  @Test
  void isDarkInLittleLightAndWhiteInTooMuch() {
    try (Homes dark = arena(4, 1);
        Homes fit = arena(150, 1);
        Homes glaring = arena(20_000, 1)) {
      int floorInTheDark = green(at(dark.simulated.photo("cam-1"), 2.2, 1.2));
      int floor = green(at(fit.simulated.photo("cam-1"), 2.2, 1.2));
      Photo white = glaring.simulated.photo("cam-1");
      assertThat(floorInTheDark).isLessThan(80);
      assertThat(floor).isBetween(100, 150);
      assertThat(green(at(white, 2.2, 1.2))).isGreaterThan(250);
      int washedOut = at(white, 1.2, 2.0);
      assertThat(red(washedOut)).isGreaterThan(180);
    }
  }

  @Test
  void isTheSameWithTheSameSeedAndChangesNothing() {
    try (Homes first = arena(100, 1);
        Homes same = arena(100, 1);
        Homes other = arena(100, 2)) {
      Photo photo = first.simulated.photo("cam-1");
      assertThat(photo.rgb()).isEqualTo(same.simulated.photo("cam-1").rgb());
      assertThat(photo.rgb()).isNotEqualTo(other.simulated.photo("cam-1").rgb());
    }
  }

  @Test
  void comesFromTheDriverAFrameLater() {
    try (Homes homes = arena(100, 1)) {
      List<Photo> taken = new ArrayList<>();
      Duration begun = homes.clock.now();
      homes
          .simulated
          .drivers("cam-1")
          .find(Camera.class)
          .orElseThrow()
          .photograph(
              new Camera.PhotoListener() {
                @Override
                public void taken(Photo photo) {
                  taken.add(photo);
                }

                @Override
                public void failed(String reason) {
                  throw new AssertionError(reason);
                }
              });
      homes.clock.runUntil(() -> !taken.isEmpty(), Duration.ofSeconds(1));
      assertThat(homes.clock.now().minus(begun).toMillis()).isBetween(33L, 34L);
      assertThat(taken).hasSize(1);
    }
  }
}
