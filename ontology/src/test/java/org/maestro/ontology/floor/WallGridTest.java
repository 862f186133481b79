package org.maestro.ontology.floor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

/** Ways are crossed by the walls that comparing them with every wall finds. */
class WallGridTest {

  @Property(tries = 300)
  void findsWhatEveryWallTogetherFinds(@ForAll Random random) {
    List<Segment> walls = walls(random);
    WallGrid grid = new WallGrid(walls);
    for (int way = 0; way < 50; way++) {
      Segment one = new Segment(point(random, 14), point(random, 14));
      assertThat(grid.isCrossed(one))
          .as("%s among %s", one, walls)
          .isEqualTo(walls.stream().anyMatch(one::intersects));
    }
  }

  @Example
  void findsNothingWhereThereAreNoWalls() {
    assertThat(new WallGrid(List.of()).isCrossed(segment(0, 0, 5, 5))).isFalse();
  }

  @Example
  void findsWallsOnOneLine() {
    WallGrid grid = new WallGrid(List.of(segment(0, 1, 4, 1), segment(6, 1, 9, 1)));
    assertThat(grid.isCrossed(segment(5, 0, 5, 3))).isFalse();
    assertThat(grid.isCrossed(segment(4, 0, 4, 3))).isTrue();
    assertThat(grid.isCrossed(segment(-3, 1, 20, 1))).isTrue();
    assertThat(grid.isCrossed(segment(5, 1, 5.5, 1))).isFalse();
    assertThat(grid.isCrossed(segment(20, 0, 30, 3))).isFalse();
  }

  private static Segment segment(double x1, double y1, double x2, double y2) {
    return new Segment(new Point2(x1, y1), new Point2(x2, y2));
  }

  /** Rooms on a raster, so that much touches, and walls that stand as they like. */
  private static List<Segment> walls(Random random) {
    List<Segment> walls = new ArrayList<>();
    for (int i = random.nextInt(12); i > 0; i--) {
      walls.add(new Segment(point(random, 10), point(random, 10)));
    }
    for (int i = random.nextInt(12); i > 0; i--) {
      double x = random.nextInt(5) * 2;
      double y = random.nextInt(5) * 2;
      walls.add(random.nextBoolean() ? segment(x, y, x + 2, y) : segment(x, y, x, y + 2));
    }
    return walls;
  }

  private static Point2 point(Random random, int most) {
    return random.nextBoolean()
        ? new Point2(random.nextInt(most) - 2, random.nextInt(most) - 2)
        : new Point2(random.nextDouble() * most - 2, random.nextDouble() * most - 2);
  }
}
