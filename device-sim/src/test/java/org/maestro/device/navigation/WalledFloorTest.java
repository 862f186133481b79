package org.maestro.device.navigation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/** What squares of the floor know of walls is what holding a way against every wall would tell. */
class WalledFloorTest {

  private static final double RADIUS = 0.35;
  private static final double METRES = 12;

  private static Point2 point(Random random) {
    return new Point2(METRES * random.nextDouble() - 1, METRES * random.nextDouble() - 1);
  }

  private static Segment wall(Random random) {
    Point2 from = point(random);
    boolean across = random.nextBoolean();
    double length = 4 * random.nextDouble();
    return new Segment(
        from,
        random.nextInt(4) == 0
            ? point(random)
            : new Point2(from.x() + (across ? length : 0), from.y() + (across ? 0 : length)));
  }

  private static boolean isBarred(List<Segment> walls, Segment way) {
    return walls.stream()
        .anyMatch(
            wall ->
                apart(wall, way) < Math.min(RADIUS, wall.distance(way.from())) - FreeFloor.TOLERANCE
                    || wall.intersects(way));
  }

  private static double apart(Segment first, Segment second) {
    return Math.min(
        Math.min(first.distance(second.from()), first.distance(second.to())),
        Math.min(second.distance(first.from()), second.distance(first.to())));
  }

  @Test
  void agreesWithHoldingAWayAgainstEveryWall() {
    Random random = new Random(7);
    int barred = 0;
    for (int home = 0; home < 60; home++) {
      List<Segment> walls = new ArrayList<>();
      for (int i = 0; i < home % 20; i++) {
        walls.add(wall(random));
      }
      WalledFloor floor = new WalledFloor(walls, RADIUS);
      FreeFloor.Memory memory = new FreeFloor.Memory();
      for (int i = 0; i < 300; i++) {
        Segment way = new Segment(point(random), point(random));
        boolean isBarred = isBarred(walls, way);
        barred += isBarred ? 1 : 0;
        assertThat(floor.isFreeWay(way, memory)).as("%s among %s", way, walls).isEqualTo(!isBarred);
        assertThat(floor.isFree(way.from()))
            .isEqualTo(
                walls.stream()
                    .allMatch(wall -> wall.distance(way.from()) >= RADIUS - FreeFloor.TOLERANCE));
      }
    }
    assertThat(barred).isBetween(5_000, 15_000);
  }
}
