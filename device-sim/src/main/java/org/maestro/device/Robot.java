package org.maestro.device;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.maestro.hal.Area;
import org.maestro.hal.Completion;
import org.maestro.hal.MobileBase;
import org.maestro.hal.Surroundings;
import org.maestro.ontology.home.Point2;
import org.maestro.ontology.home.Segment;

/**
 * How a mobile robot finds its ways: its base, and what it knows of the floor. Clock thread only.
 */
final class Robot {

  /** Times that a drive is planned anew when something came in the way. */
  private static final int ATTEMPTS = 3;

  private static final double GRID_METRES = 0.25;

  private final MobileBase base;
  private final Surroundings surroundings;

  Robot(FeatureContext context) {
    this.base = context.driver(MobileBase.class);
    this.surroundings = context.driver(Surroundings.class);
  }

  MobileBase base() {
    return base;
  }

  Surroundings surroundings() {
    return surroundings;
  }

  Optional<Route> routeToNearest(List<Point2> goals) {
    return new RoutePlanner(surroundings.walls(), surroundings.obstacles(), base.radius())
        .shortest(base.position(), goals);
  }

  double seconds(Route route) {
    return route.length() / base.speed();
  }

  double joules(Route route) {
    return seconds(route) * base.power();
  }

  Optional<Area> area(String name) {
    return surroundings.areas().stream().filter(area -> area.name().equals(name)).findFirst();
  }

  boolean isOnMap(Point2 point) {
    return surroundings.areas().stream().anyMatch(area -> area.outline().contains(point));
  }

  /**
   * Points of an area at which the whole base stands in it; just its middle where it is too narrow.
   */
  List<Point2> standsIn(Area area) {
    List<Segment> edges = area.outline().edges();
    List<Point2> stands = new ArrayList<>();
    if (isWholly(base.position(), area, edges)) {
      stands.add(base.position());
    }
    for (Point2 point : area.outline().samples(GRID_METRES)) {
      if (isWholly(point, area, edges)) {
        stands.add(point);
      }
    }
    return stands.isEmpty() ? List.of(area.outline().centroid()) : stands;
  }

  private boolean isWholly(Point2 point, Area area, List<Segment> edges) {
    return area.outline().contains(point)
        && edges.stream().allMatch(edge -> edge.distance(point) >= base.radius());
  }

  /**
   * Drives along what is planned; when something came in the way, along what is then planned anew.
   */
  void drive(Supplier<Optional<Route>> plan, Completion completion) {
    drive(plan, completion, ATTEMPTS);
  }

  private void drive(Supplier<Optional<Route>> plan, Completion completion, int attempts) {
    Optional<Route> route = plan.get();
    if (route.isEmpty()) {
      completion.failed("there is no free way");
      return;
    }
    base.drive(
        route.get().way(),
        new Completion() {
          @Override
          public void done() {
            completion.done();
          }

          @Override
          public void failed(String reason) {
            if (attempts > 1) {
              drive(plan, completion, attempts - 1);
            } else {
              completion.failed(reason);
            }
          }
        });
  }
}
