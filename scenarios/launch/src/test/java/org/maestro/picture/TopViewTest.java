package org.maestro.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.geom.Point2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.hal.Position;
import org.maestro.junit.MaestroAssertions;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.home.Geometry;
import org.maestro.ontology.home.Home;

class TopViewTest {

  private static final int REACH = 30;

  @TempDir Path directory;

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark")
  class BobsHome {

    @Test
    void showsWhatIsWhere(Stage stage) throws IOException {
      Home home = stage.knowledge().home();
      TopView view = new TopView(home, stage.world());
      int dark = brightness(draw(view), home, new Point2(5.5, 2.7));
      stage.world().setAmbient("zone-b", 200);
      stage.world().moveByHand("Cup", new Position(4, 2, 0));

      BufferedImage picture = draw(view);

      assertThat(picture.getWidth()).isEqualTo(1600);
      assertThat(brightness(picture, home, new Point2(5.5, 2.7))).isGreaterThan(dark + 20);
      assertThat(has(picture, home, new Point2(0.8, 2.1), Palette.PERSON)).isTrue();
      assertThat(has(picture, home, new Point2(4.0, 0.8), Palette.ROBOT)).isTrue();
      assertThat(has(picture, home, new Point2(4, 2), own(stage, "Cup"))).isTrue();
      assertThat(has(picture, home, new Point2(5.2, 2.2), own(stage, "Cup")))
          .as("at first")
          .isTrue();
      assertThat(has(picture, home, new Point2(1.5, 1.5), Palette.CAMERA)).isTrue();
      assertThat(has(picture, home, new Point2(1.1, 1.5), Palette.LAMP)).as("lit").isTrue();
      assertThat(has(picture, home, new Point2(4.1, 1.5), Palette.LAMP)).as("dark").isFalse();
      assertThat(has(picture, home, new Point2(3, 1), Palette.INK)).as("wall").isTrue();
      assertThat(has(picture, home, new Point2(3, 2.35), Palette.INK)).as("door").isFalse();
    }
  }

  @Nested
  @MaestroTest(home = "arena", scene = "arena-dark")
  class Arena {

    @Test
    void showsItsFieldsThingsAndLampsToo(Stage stage) throws IOException {
      Home home = stage.knowledge().home();

      BufferedImage picture = draw(new TopView(home, stage.world()));

      assertThat(picture.getWidth()).isEqualTo(1600);
      assertThat(has(picture, home, new Point2(1.2, 2.0), own(stage, "GreenObject"))).isTrue();
      assertThat(has(picture, home, new Point2(4.2, 1.5), Palette.CAMERA)).isTrue();
      assertThat(has(picture, home, new Point2(0.9, 1.5), Palette.LAMP)).as("dark").isFalse();
      assertThat(has(picture, home, new Point2(3.55, 1.5), Palette.CAMERA)).as("field").isTrue();
      assertThat(hasAnywhere(picture, Palette.ROBOT)).isTrue();
      assertThat(hasAnywhere(picture, Palette.GLASS)).as("a window, in the legend").isFalse();
      assertThat(hasAnywhere(picture, Palette.PERSON)).as("a person, in the legend").isFalse();
    }
  }

  @Nested
  @MaestroTest(home = "arena-windows", scene = "arena-windows")
  class ByDay {

    @Test
    void showsWindowsAndHowFarTheirShuttersAreOpen(Stage stage) throws IOException {
      Home home = stage.knowledge().home();
      Point2 west = new Point2(1.4, 0);

      assertThat(has(draw(new TopView(home, stage.world())), home, west, Palette.GLASS))
          .as("shutters are closed at first")
          .isFalse();
      MaestroAssertions.assertThat(stage.goal("(= (opening shutter-west) 1)")).isReached();
      BufferedImage open = draw(new TopView(home, stage.world()));
      assertThat(has(open, home, west, Palette.GLASS)).isTrue();
      assertThat(has(open, home, new Point2(7, 0), Palette.GLASS)).isFalse();
      assertThat(own(stage, "GreenObject").getGreen())
          .isGreaterThan(own(stage, "GreenObject").getRed());
    }
  }

  private static Color own(Stage stage, String thing) {
    return Palette.screen(stage.world().paint(thing));
  }

  private BufferedImage draw(TopView view) throws IOException {
    Path file = directory.resolve("view.png");
    view.write(file);
    return ImageIO.read(file.toFile());
  }

  /** Whether the colour is around the place on the floor. */
  private static boolean has(BufferedImage picture, Home home, Point2 place, Color color) {
    Point2D at = scale(home).at(place);
    for (int x = -REACH; x <= REACH; x++) {
      for (int y = -REACH; y <= REACH; y++) {
        if (picture.getRGB((int) at.getX() + x, (int) at.getY() + y) == color.getRGB()) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean hasAnywhere(BufferedImage picture, Color color) {
    int[] pixels =
        picture.getRGB(0, 0, picture.getWidth(), picture.getHeight(), null, 0, picture.getWidth());
    return Arrays.stream(pixels).anyMatch(pixel -> pixel == color.getRGB());
  }

  private static int brightness(BufferedImage picture, Home home, Point2 place) {
    Point2D at = scale(home).at(place);
    return new Color(picture.getRGB((int) at.getX(), (int) at.getY())).getRed();
  }

  private static Scale scale(Home home) {
    Geometry geometry = new Geometry(home);
    Stream<Polygon> rooms =
        home.individuals().values().stream()
            .filter(individual -> individual.classes().contains("Room"))
            .map(room -> geometry.outline(room.name()).orElseThrow());
    return Scale.of(rooms.toList(), 1600);
  }
}
