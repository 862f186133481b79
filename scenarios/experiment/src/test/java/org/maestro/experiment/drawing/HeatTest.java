package org.maestro.experiment.drawing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.floor.Point2;

/** What a heat map shows, besides that it is drawn. */
class HeatTest {
  private static final double WIDTH = 8;
  private static final double DEPTH = 3;
  private static final double SECONDS = 0.02;

  /** The colours' upper end. */
  private static final int LONGEST = 0xFFFDE725;

  @Test
  void timesInASquareAreAddedUp() {
    assertThat(Heat.greatest(WIDTH, DEPTH, stay(2.05, 100), SECONDS)).isCloseTo(2, within(1e-9));
    assertThat(Heat.greatest(WIDTH, DEPTH, stay(9, 100), SECONDS)).as("off the floor").isZero();
  }

  @Test
  void whereItStayedLongestIsBrightestAndInItsPlace() {
    Rectangle west = longest(draw(stay(2.05, 100), stay(4.05, 10)));
    Rectangle east = longest(draw(stay(6.05, 100), stay(4.05, 10)));

    assertThat(west.y).isEqualTo(east.y);
    // Four metres, in squares of a tenth of a metre; a square's edge may be drawn half a pixel off.
    assertThat((east.x - west.x) / (double) west.width).isCloseTo(40, within(4.0));
  }

  private static List<Point2> stay(double x, int samples) {
    return Collections.nCopies(samples, new Point2(x, 1.05));
  }

  private static BufferedImage draw(List<Point2> longer, List<Point2> shorter) {
    List<Point2> places = Stream.concat(longer.stream(), shorter.stream()).toList();
    return Heat.draw("heat", WIDTH, DEPTH, places, SECONDS, Map.of(), 2);
  }

  /** The square in the colour of the longest time, left of the legend. */
  private static Rectangle longest(BufferedImage image) {
    Rectangle found = new Rectangle();
    for (int x = 0; x < image.getWidth() * 4 / 5; x++) {
      for (int y = 0; y < image.getHeight(); y++) {
        if (image.getRGB(x, y) == LONGEST) {
          Rectangle pixel = new Rectangle(x, y, 1, 1);
          found = found.isEmpty() ? pixel : found.union(pixel);
        }
      }
    }
    return found;
  }
}
