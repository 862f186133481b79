package org.maestro.device.navigation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
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
}
