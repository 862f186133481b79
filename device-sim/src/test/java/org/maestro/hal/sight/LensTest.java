package org.maestro.hal.sight;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import net.jqwik.api.constraints.IntRange;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Pose;

class LensTest {
  private static final int WIDTH = 640;
  private static final int HEIGHT = 360;

  @Property
  void whatAPixelShowsIsShownByThatPixel(
      @ForAll @DoubleRange(min = -180, max = 180) double yaw,
      @ForAll @DoubleRange(min = -90, max = -60) double pitch,
      @ForAll @DoubleRange(min = -30, max = 30) double roll,
      @ForAll @IntRange(min = 200, max = 440) int column,
      @ForAll @IntRange(min = 0, max = HEIGHT - 1) int row) {
    Lens lens = new Lens(new Pose(1, 2, 2.8, yaw, pitch, roll), 50, WIDTH, HEIGHT);

    Position floor = lens.at(column, row, 0).orElseThrow();
    Lens.Pixel pixel = lens.pixel(new Vector(floor.x(), floor.y(), 0)).orElseThrow();

    assertThat(pixel).isEqualTo(new Lens.Pixel(column, row));
  }

  /** Pixels of a patch of the floor, counted one by one. */
  @Property(tries = 50)
  void anAreaFillsAsManyPixelsAsItIsReckonedTo(
      @ForAll @DoubleRange(min = -1, max = 1) double x,
      @ForAll @DoubleRange(min = -0.6, max = 0.6) double y) {
    Lens lens = new Lens(Pose.parse("0 0 2.8 0 -90 0"), 75, WIDTH, HEIGHT);
    double half = 0.2;
    int counted = 0;
    for (int row = 0; row < HEIGHT; row++) {
      for (int column = 0; column < WIDTH; column++) {
        Position floor = lens.at(column, row, 0).orElseThrow();
        if (Math.abs(floor.x() - x) < half && Math.abs(floor.y() - y) < half) {
          counted++;
        }
      }
    }
    Appearance sheet = new Appearance(Paint.GREY, new Size(2 * half, 2 * half, 1e-6));
    Vector towards = new Vector(x, y, -2.8);

    assertThat(lens.pixels(sheet.area(towards), towards))
        .isCloseTo(counted, within(0.06 * counted));
  }
}
