package org.maestro.device.navigation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

class CellsTest {
  private static final double RADIUS = 0.3;
  private static final Point2 HERE = new Point2(1, 5);
  private static final List<Point2> THERE = List.of(new Point2(9, 5));

  /** A wall across, with a gap in its middle; around its ends nobody knows. */
  private static Cells withGap(double metres) {
    Cells cells = new Cells(0, 10, 0, 10);
    cells.bar(new Segment(new Point2(5, -9), new Point2(5, 5 - metres / 2)), RADIUS);
    cells.bar(new Segment(new Point2(5, 5 + metres / 2), new Point2(5, 19)), RADIUS);
    return cells;
  }

  @Test
  void whereWallsGoAllAroundNobodyComesIn() {
    Cells cells = new Cells(0, 10, 0, 10);
    Point2[] corners = {
      new Point2(8, 4), new Point2(9.8, 4), new Point2(9.8, 6), new Point2(8, 6), new Point2(8, 4)
    };
    for (int i = 1; i < corners.length; i++) {
      cells.bar(new Segment(corners[i - 1], corners[i]), RADIUS);
    }
    assertThat(cells.connect(HERE, THERE)).isFalse();
    assertThat(cells.connect(HERE, List.of(new Point2(5, 5)))).isTrue();
  }

  @Test
  void whatMayFitIsLeftToOthers() {
    assertThat(withGap(0.7).connect(HERE, THERE)).isTrue();
  }

  /** Metres taken for kilometres: squares get larger, not more. */
  @Test
  void nothingIsSaidOfAFloorThatIsFarTooWide() {
    Cells cells = new Cells(0, 5e6, 0, 5e6);
    cells.bar(new Segment(new Point2(5, 0), new Point2(5, 5e6)), RADIUS);
    assertThat(cells.connect(HERE, List.of(new Point2(4e6, 4e6)))).isTrue();
  }
}
