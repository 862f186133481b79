package org.maestro.hal.sight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Photo;
import org.maestro.hal.Position;
import org.maestro.hal.sight.Detector.Place;
import org.maestro.ontology.floor.Pose;

class DetectorTest {
  private static final int WIDTH = 320;
  private static final int HEIGHT = 180;
  private static final int FLOOR = 0x888682;
  private static final int RED = 0xc83838;
  private static final int WHITE = 0xffffff;

  /** Straight down from 3 m: a pixel shows 2.57 cm of the floor. */
  private static final Lens LENS = new Lens(Pose.parse("0 0 3 0 -90 0"), 75, WIDTH, HEIGHT);

  private static final Detector DETECTOR = new Detector(0.1, false);
  private static final Appearance BOX = box("0.3 0.3 0.02", "red");

  private static Appearance box(String size, String colour) {
    return Appearance.read(List.of(colour, size)).orElseThrow();
  }

  /** A floor with a square upon it, whose sides are so many pixels. */
  private static Photo photo(int column, int row, int side, int rgb) {
    int[] pixels = new int[WIDTH * HEIGHT];
    Arrays.fill(pixels, FLOOR);
    for (int r = row; r < row + side; r++) {
      Arrays.fill(pixels, r * WIDTH + column, r * WIDTH + column + side, rgb);
    }
    return new Photo(WIDTH, HEIGHT, pixels);
  }

  private static List<Sighting> found(Photo photo, Appearance wanted, Appearance... others) {
    return DETECTOR.find(photo, LENS, wanted, List.of(others));
  }

  @Test
  void saysWhereItStands() {
    // its middle is 54 pixels to the right of the picture's and 36 above it
    List<Sighting> found = found(photo(208, 48, 12, RED), BOX);

    assertThat(found).hasSize(1);
    Position foot = found.get(0).foot();
    assertThat(foot.x()).isCloseTo(54 * 0.0256, within(0.02));
    assertThat(foot.y()).isCloseTo(36 * 0.0256, within(0.02));
    assertThat(found.get(0).confidence()).isGreaterThan(0.8);
  }

  @Test
  void whatHasAnotherColourOrSizeIsNotIt() {
    assertThat(found(photo(100, 100, 12, 0x2ca040), BOX)).isEmpty();
    assertThat(found(photo(100, 100, 40, RED), BOX)).isEmpty();
    assertThat(found(photo(100, 100, 5, RED), BOX)).isEmpty();
    assertThat(found(photo(100, 100, 12, RED), box("0.3 0.3 0.02", "grey"))).isEmpty();
  }

  @Test
  void whatIsDarkOrAtItsEndHasNoColour() {
    assertThat(found(photo(100, 100, 12, 0x0a0202), BOX)).isEmpty();
    Photo atItsEnd = photo(100, 100, 12, 0xff5858);
    assertThat(found(atItsEnd, BOX)).isEmpty();
    assertThat(new Detector(0.1, true).find(atItsEnd, LENS, BOX, List.of())).hasSize(1);
  }

  @Test
  void theSizeTellsWhichOfTwoOfOneColourItIs() {
    Appearance smaller = box("0.2 0.2 0.02", "red");
    Photo photo = photo(100, 100, 8, RED);

    assertThat(found(photo, BOX)).hasSize(1);
    assertThat(found(photo, BOX, smaller)).isEmpty();
    assertThat(found(photo, smaller, BOX)).hasSize(1);
    assertThat(DETECTOR.areAlike(BOX, smaller)).isFalse();
    assertThat(DETECTOR.areAlike(BOX, box("0.28 0.3 0.02", "red"))).isTrue();
    assertThat(DETECTOR.areAlike(BOX, box("0.3 0.3 0.02", "blue"))).isFalse();
  }

  @Test
  void saysWhetherSomethingMayHideIt() {
    Position there = new Position((106 - WIDTH / 2.0) * 0.0256, (HEIGHT / 2.0 - 106) * 0.0256, 0);
    Position origin = new Position(0, 0, 0);
    Photo floor = photo(0, 0, 1, FLOOR);

    assertThat(place(floor, BOX, origin)).isEqualTo(Place.FREE);
    assertThat(place(photo(90, 90, 32, 0x2ca040), BOX, there)).isEqualTo(Place.COVERED);
    assertThat(place(photo(80, 80, 50, WHITE), BOX, there)).isEqualTo(Place.UNSEEN);
    assertThat(place(photo(80, 80, 50, 0x101010), BOX, there)).isEqualTo(Place.UNSEEN);
    assertThat(place(floor, BOX, new Position(9, 0, 0))).isEqualTo(Place.UNSEEN);
    assertThat(place(floor, box("0.02 0.02 0.02", "red"), origin)).isEqualTo(Place.UNSEEN);
  }

  private static Place place(Photo photo, Appearance wanted, Position foot) {
    return DETECTOR.place(photo, LENS, wanted, foot);
  }

  @Test
  void looksAreReadFromWhatIsStated() {
    assertThat(Appearance.read(List.of("0.1 0.2 0.3", "#a03020"))).isPresent();
    assertThat(Appearance.read(List.of("red"))).isEqualTo(Optional.empty());
    assertThat(Appearance.read(List.of("red", "0.1 0 0.3"))).isEmpty();
  }
}
