package org.maestro.ontology.floor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

/** Ways through rooms on a raster, some of which have openings to each other. */
class WayFinderTest {
  private static final int ROOMS_A_SIDE = 3;
  private static final double SIDE = 4;

  @Property(tries = 60)
  void whatWasAskedBeforeChangesNoWay(@ForAll Random random) {
    List<Segment> openings = openings(random);
    WayFinder asked = finder(openings);
    for (int way = 0; way < 30; way++) {
      Point2 from = point(random.nextInt(3), random);
      Point2 to = point(random.nextInt(9), random);
      OptionalDouble anew = finder(openings).length(from, to);

      assertThat(asked.length(from, to)).isEqualTo(anew);
      assertThat(anew.isPresent()).isEqualTo(finder(openings).length(to, from).isPresent());
      if (anew.isPresent()) {
        assertThat(anew.getAsDouble()).isGreaterThanOrEqualTo(from.distance(to) - 1e-9);
        assertThat(finder(openings).length(to, from).orElseThrow())
            .isCloseTo(anew.getAsDouble(), within(1e-9));
      }
    }
  }

  /** No way is longer than the one over any place between. */
  @Property(tries = 60)
  void noWayIsLongerThanOverAnOpening(@ForAll Random random) {
    List<Segment> openings = openings(random);
    WayFinder finder = finder(openings);
    Point2 from = point(random.nextInt(9), random);
    Point2 to = point(random.nextInt(9), random);
    for (Segment opening : openings) {
      OptionalDouble first = finder.length(from, opening.middle());
      OptionalDouble second = finder.length(opening.middle(), to);
      if (first.isPresent() && second.isPresent()) {
        assertThat(finder.length(from, to).orElseThrow())
            .isLessThanOrEqualTo(first.getAsDouble() + second.getAsDouble() + 1e-9);
      }
    }
  }

  private static WayFinder finder(List<Segment> openings) {
    List<Polygon> rooms = new ArrayList<>();
    for (int room = 0; room < ROOMS_A_SIDE * ROOMS_A_SIDE; room++) {
      double x = left(room);
      double y = bottom(room);
      rooms.add(
          Polygon.parse(
              "%s %s, %s %s, %s %s, %s %s"
                  .formatted(x, y, x + SIDE, y, x + SIDE, y + SIDE, x, y + SIDE)));
    }
    return new WayFinder(new FloorPlan(rooms, openings), rooms, openings);
  }

  private static List<Segment> openings(Random random) {
    List<Segment> openings = new ArrayList<>();
    for (int room = 0; room < ROOMS_A_SIDE * ROOMS_A_SIDE; room++) {
      double x = left(room);
      double y = bottom(room);
      if (x > 0 && random.nextInt(3) > 0) {
        openings.add(new Segment(new Point2(x, y + 1), new Point2(x, y + 2)));
      }
      if (y > 0 && random.nextInt(3) > 0) {
        openings.add(new Segment(new Point2(x + 2, y), new Point2(x + 3, y)));
      }
    }
    return openings;
  }

  private static double left(int room) {
    return room % ROOMS_A_SIDE * SIDE;
  }

  private static double bottom(int room) {
    return room / ROOMS_A_SIDE * SIDE;
  }

  private static Point2 point(int room, Random random) {
    return new Point2(
        left(room) + 0.5 + 3 * random.nextDouble(), bottom(room) + 0.5 + 3 * random.nextDouble());
  }
}
