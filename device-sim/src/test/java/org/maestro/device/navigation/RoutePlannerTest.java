package org.maestro.device.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.Assume;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.DoubleRange;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

class RoutePlannerTest {

  private static final Segment WALL = new Segment(new Point2(2, -1), new Point2(2, 1));
  private static final double RADIUS = 0.3;

  private static Point2 point(double x, double y) {
    return new Point2(x, y);
  }

  @Test
  void goesStraightWhereItCan() {
    Route route =
        new RoutePlanner(List.of(WALL), List.of(), RADIUS)
            .shortest(point(0, 2), List.of(point(4, 2)))
            .orElseThrow();
    assertThat(route.way()).containsExactly(point(4, 2));
    assertThat(route.length()).isEqualTo(4);
  }

  @Test
  void goesAroundTheEndOfAWall() {
    Route route =
        new RoutePlanner(List.of(WALL), List.of(), RADIUS)
            .shortest(point(0, 0), List.of(point(4, 0)))
            .orElseThrow();
    // a string around a circle of 0.3 m at the wall's end, 2 m along and 1 m up from both ends:
    // twice the tangent sqrt(5 - 0.09), and the arc between the tangents
    double tangent = Math.sqrt(5 - RADIUS * RADIUS);
    double arc =
        RADIUS
            * (Math.PI
                - 2 * (Math.atan2(2, 1) - 0)
                + 2 * (Math.PI / 2 - Math.acos(RADIUS / Math.sqrt(5))));
    assertThat(route.length()).isCloseTo(2 * tangent + arc, within(0.02 * route.length()));
    assertThat(route.length()).isGreaterThan(2 * Math.sqrt(5));
  }

  @Test
  void goesToTheNearestOfSeveralGoals() {
    RoutePlanner planner = new RoutePlanner(List.of(WALL), List.of(), RADIUS);
    Route route = planner.shortest(point(0, 0), List.of(point(2.6, 0), point(0, 3))).orElseThrow();
    assertThat(route.way()).containsExactly(point(0, 3));
    assertThat(planner.shortest(point(0, 0), List.of(point(0, 0))).orElseThrow().length()).isZero();
  }

  @Test
  void findsNoWayIntoAClosedRoomOrAnOccupiedPlace() {
    List<Segment> room =
        List.of(
            new Segment(point(0, 0), point(3, 0)),
            new Segment(point(3, 0), point(3, 3)),
            new Segment(point(3, 3), point(0, 3)),
            new Segment(point(0, 3), point(0, 0)));
    RoutePlanner planner =
        new RoutePlanner(room, List.of(new Obstacle("body", point(1.5, 1.5), 0.2)), RADIUS);
    assertThat(planner.shortest(point(0.5, 0.5), List.of(point(5, 5)))).isEmpty();
    assertThat(planner.shortest(point(0.5, 0.5), List.of(point(1.6, 1.5)))).isEmpty();
    assertThat(planner.shortest(point(0.5, 0.5), List.of(point(2.5, 2.5)))).isPresent();
  }

  @Test
  void passesADoorOnlyIfItFits() {
    List<Segment> wall =
        List.of(new Segment(point(2, -9), point(2, 0)), new Segment(point(2, 0.7), point(2, 9)));
    Point2 from = point(0, 0);
    List<Point2> to = List.of(point(4, 0));
    assertThat(new RoutePlanner(wall, List.of(), 0.34).shortest(from, to).orElseThrow().length())
        .isLessThan(5);
    assertThat(new RoutePlanner(wall, List.of(), 0.36).shortest(from, to).orElseThrow().length())
        .isGreaterThan(18);
  }

  @Property(tries = 200)
  void keepsClearOfEverything(
      @ForAll @DoubleRange(min = 0, max = 4) double x,
      @ForAll @DoubleRange(min = 0, max = 4) double y,
      @ForAll @DoubleRange(min = 0, max = 0.5) double thickness) {
    Obstacle obstacle = new Obstacle("body", point(x, y), thickness);
    RoutePlanner planner = new RoutePlanner(List.of(WALL), List.of(obstacle), RADIUS);
    Point2 start = point(-1, -0.5);
    planner
        .shortest(start, List.of(point(5, 0.5)))
        .ifPresent(
            route -> {
              Point2 at = start;
              for (Point2 next : route.way()) {
                Segment piece = new Segment(at, next);
                assertThat(piece.distance(obstacle.middle()))
                    .isGreaterThanOrEqualTo(
                        Math.min(start.distance(obstacle.middle()), thickness + RADIUS) - 1e-5);
                assertThat(piece.intersects(WALL)).isFalse();
                at = next;
              }
            });
  }

  @Property(tries = 2000)
  void isAsShortAsOverAllCornersThereAre(@ForAll long seed) {
    compareWithAllCorners(seed);
  }

  @Property(tries = 20000)
  @Tag("full")
  void isAsShortAsOverAllCornersInManyHomes(@ForAll long seed) {
    compareWithAllCorners(seed);
  }

  /**
   * Rooms side by side, with doors between them, and bodies on the floor, some of them in doors.
   */
  private static void compareWithAllCorners(long seed) {
    Random random = new Random(seed);
    List<Segment> walls = new ArrayList<>();
    int rooms = 2 + random.nextInt(3);
    for (int room = 0; room <= rooms; room++) {
      double x = 4.0 * room;
      double door = 0.5 + 2 * random.nextDouble();
      double width = room == 0 || room == rooms ? 0 : 0.6 + random.nextDouble();
      walls.add(new Segment(point(x, 0), point(x, door)));
      walls.add(new Segment(point(x, door + width), point(x, 4)));
    }
    walls.add(new Segment(point(0, 0), point(4.0 * rooms, 0)));
    walls.add(new Segment(point(0, 4), point(4.0 * rooms, 4)));
    List<Obstacle> bodies = new ArrayList<>();
    for (int i = random.nextInt(12); i > 0; i--) {
      Point2 place =
          random.nextInt(4) == 0
              ? walls.get(random.nextInt(2 * rooms)).to()
              : somewhere(random, rooms);
      bodies.add(new Obstacle("body-" + i, place, 0.5 * random.nextDouble()));
    }
    Point2 start = somewhere(random, rooms);
    List<Point2> goals = new ArrayList<>();
    for (int i = 1 + random.nextInt(5); i > 0; i--) {
      goals.add(somewhere(random, rooms));
    }

    RoutePlanner planner = new RoutePlanner(walls, bodies, RADIUS);
    Assume.that(new RoutePlanner(walls, bodies, 1.02 * RADIUS).isFree(start));
    Optional<Route> route = planner.shortest(start, goals);

    OptionalDouble expected = new WholeGraph(walls, bodies, RADIUS).shortest(start, goals);
    OptionalDouble ofWider = new WholeGraph(walls, bodies, 1.02 * RADIUS).shortest(start, goals);
    assertThat(planner.isCutOff(start, goals) && expected.isPresent()).isFalse();
    assertThat(route.map(Route::length).orElse(Double.POSITIVE_INFINITY))
        .isBetween(
            expected.orElse(Double.POSITIVE_INFINITY) - 1e-5,
            1.02 * ofWider.orElse(Double.POSITIVE_INFINITY));
  }

  private static Point2 somewhere(Random random, int rooms) {
    return point(4.0 * rooms * random.nextDouble(), 4 * random.nextDouble());
  }
}
