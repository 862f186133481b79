package org.maestro.device.tasks;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.maestro.device.navigation.Route;
import org.maestro.device.navigation.RoutePlanner;
import org.maestro.device.navigation.WalledFloor;
import org.maestro.hal.Area;
import org.maestro.hal.Completion;
import org.maestro.hal.MobileBase;
import org.maestro.hal.Surroundings;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/**
 * The navigation of a mobile robot: its base, and what it knows of the floor. Clock thread only.
 */
final class Robot {

  /** Times that a drive is planned anew when something came in the way. */
  private static final int ATTEMPTS = 3;

  private static final double GRID_METRES = 0.25;

  /** So much farther in than need be, lest rounding makes it stand outside; metres. */
  private static final double BESIDE_METRES = 1e-4;

  /** A thing for which it comes is no nearer than this to its body; metres. */
  private static final double CLEARANCE_METRES = 0.1;

  private static final int DIRECTIONS = 16;

  private final MobileBase base;
  private final Surroundings surroundings;
  private final Motion motion;
  private WalledFloor walls;
  private WalledFloor wallsInView;

  Robot(FeatureContext context) {
    this.base = context.driver(MobileBase.class);
    this.surroundings = context.driver(Surroundings.class);
    this.motion = context.motion();
    this.walls = new WalledFloor(List.of(), base.radius());
    this.wallsInView = walls;
  }

  private Robot(MobileBase base, Surroundings surroundings, Motion motion, WalledFloor walls) {
    this.base = base;
    this.surroundings = surroundings;
    this.motion = motion;
    this.walls = walls;
    this.wallsInView = walls;
  }

  MobileBase base() {
    return base;
  }

  Surroundings surroundings() {
    return surroundings;
  }

  Optional<Route> routeToNearest(List<Point2> goals) {
    return route(base.position(), goals);
  }

  /**
   * The way to the nearest of the goals, if it stood there: amid all that it has seen, else amid
   * what it sees now, since only going there shows whether the rest is there still.
   */
  Optional<Route> route(Point2 start, List<Point2> goals) {
    walls = walls.with(surroundings.walls());
    return new RoutePlanner(walls, surroundings.obstacles())
        .shortest(start, goals)
        .or(() -> routeInView(start, goals));
  }

  private Optional<Route> routeInView(Point2 start, List<Point2> goals) {
    Surroundings now = surroundings.inView();
    if (now.equals(surroundings)) {
      return Optional.empty();
    }
    wallsInView = now.walls().equals(surroundings.walls()) ? walls : wallsInView.with(now.walls());
    return new RoutePlanner(wallsInView, now.obstacles()).shortest(start, goals);
  }

  /** There is no free way, as these stand in it. */
  void barredBy(List<String> names) {
    motion.barredBy(names);
  }

  /** The same robot, if nothing stood on the floor that it sees but this. */
  Robot amid(List<Obstacle> obstacles) {
    return new Robot(base, new Amid(surroundings.inView(), obstacles), motion, wallsInView);
  }

  /** The body of that name, if it is in view now. */
  Optional<Obstacle> seen(String body) {
    return surroundings.inView().obstacles().stream()
        .filter(obstacle -> obstacle.name().equals(body))
        .findFirst();
  }

  /** The body in view that stands nearest to a place, and no farther from it than that. */
  Optional<Obstacle> seenAt(Point2 place, double metres) {
    return surroundings.inView().obstacles().stream()
        .filter(obstacle -> obstacle.middle().distance(place) <= metres)
        .min(Comparator.comparingDouble(obstacle -> obstacle.middle().distance(place)));
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

  /**
   * @throws InvalidCallException when it is not on the map, and comes without outline
   */
  Area area(Pointer place) {
    return place
        .outline()
        .map(outline -> new Area(place.name(), outline, outline.centroid()))
        .or(() -> area(place.name()))
        .orElseThrow(
            () ->
                new InvalidCallException(
                    "The place " + place.name() + " is not on the map and comes without outline."));
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
    for (Segment edge : edges) {
      for (Point2 point : beside(edge)) {
        if (isWholly(point, area, edges)) {
          stands.add(point);
        }
      }
    }
    for (Point2 point : area.outline().samples(GRID_METRES)) {
      if (isWholly(point, area, edges)) {
        stands.add(point);
      }
    }
    return stands.isEmpty() ? List.of(area.outline().centroid()) : stands;
  }

  /**
   * The ends of lanes, each as far from the next as the base is wide, in the order in which they
   * are driven: the whole of an area but what is too narrow, or where something stands.
   */
  List<Point2> lanes(Area area) {
    List<Segment> edges = area.outline().edges();
    SortedMap<Double, List<Point2>> rows = new TreeMap<>();
    for (Point2 point : area.outline().samples(2 * base.radius())) {
      if (isWholly(point, area, edges) && routeToNearest(List.of(point)).isPresent()) {
        rows.computeIfAbsent(point.y(), y -> new ArrayList<>()).add(point);
      }
    }
    List<Point2> ends = new ArrayList<>();
    for (List<Point2> row : rows.values()) {
      Point2 first = row.get(0);
      Point2 last = row.get(row.size() - 1);
      boolean isForth = ends.size() % 4 == 0;
      ends.add(isForth ? first : last);
      ends.add(isForth ? last : first);
    }
    return ends;
  }

  /** Where it stands right beside an edge, on either side, as near as can be to where it is. */
  private List<Point2> beside(Segment edge) {
    double length = edge.length();
    if (length <= 2 * base.radius()) {
      return List.of();
    }
    double margin = base.radius() / length;
    double alongX = (edge.to().x() - edge.from().x()) / length;
    double alongY = (edge.to().y() - edge.from().y()) / length;
    Point2 here = base.position();
    double along = (here.x() - edge.from().x()) * alongX + (here.y() - edge.from().y()) * alongY;
    Point2 foot = edge.at(Math.max(margin, Math.min(1 - margin, along / length)));
    double away = base.radius() + BESIDE_METRES;
    double x = alongY * away;
    double y = -alongX * away;
    return List.of(new Point2(foot.x() + x, foot.y() + y), new Point2(foot.x() - x, foot.y() - y));
  }

  /**
   * The shortest way to a place beyond, as far as to where the whole base stands in the area; empty
   * when there is no such way, or it does not lead through the area.
   */
  Optional<Route> routeInto(Area area, Point2 beyond) {
    List<Segment> edges = area.outline().edges();
    return routeToNearest(around(beyond, base.radius() + CLEARANCE_METRES))
        .flatMap(route -> route.until(base.position(), point -> isWholly(point, area, edges)));
  }

  /** Points around a middle, the one that is nearest to the robot first. */
  List<Point2> around(Point2 middle, double distance) {
    List<Point2> points = new ArrayList<>();
    Point2 here = base.position();
    double away = here.distance(middle);
    if (away > distance) {
      points.add(new Segment(middle, here).at(distance / away));
    }
    for (int i = 0; i < DIRECTIONS; i++) {
      double angle = 2 * Math.PI * i / DIRECTIONS;
      points.add(
          new Point2(
              middle.x() + distance * Math.cos(angle), middle.y() + distance * Math.sin(angle)));
    }
    return points;
  }

  private boolean isWholly(Point2 point, Area area, List<Segment> edges) {
    return area.outline().contains(point)
        && edges.stream().allMatch(edge -> edge.distance(point) >= base.radius());
  }

  /**
   * Drives along what is planned; when something came in the way, along what is then planned anew.
   *
   * @param noWay what is said when there is none
   */
  void drive(Supplier<Optional<Route>> plan, Supplier<String> noWay, Completion completion) {
    motion.begin(() -> completion.failed("it was told to stand still"));
    drive(plan, noWay, ending(completion), ATTEMPTS);
  }

  /**
   * Drives straight to a point, or as far as the way is free.
   *
   * @param halted told instead of the completion when it is told to stand still
   */
  void driveStraight(Point2 end, Runnable halted, Completion completion) {
    motion.begin(halted);
    base.drive(List.of(end), ending(completion));
  }

  /** Stands still; nobody is told. */
  void stop() {
    motion.over();
    base.stop();
  }

  /** Whether it could go straight to a point from where it is. */
  boolean isFreeTo(Point2 point) {
    walls = walls.with(surroundings.walls());
    return new RoutePlanner(walls, surroundings.obstacles()).isFreeWay(base.position(), point);
  }

  /** The same, when the motion is noted to be over. */
  private Completion ending(Completion completion) {
    return new Completion() {
      @Override
      public void done() {
        motion.over();
        completion.done();
      }

      @Override
      public void failed(String reason) {
        motion.over();
        completion.failed(reason);
      }
    };
  }

  private void drive(
      Supplier<Optional<Route>> plan, Supplier<String> noWay, Completion completion, int attempts) {
    Optional<Route> route = plan.get();
    if (route.isEmpty()) {
      completion.failed(noWay.get());
      return;
    }
    motion.free();
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
              drive(plan, noWay, completion, attempts - 1);
            } else {
              completion.failed(reason);
            }
          }
        });
  }

  private record Amid(Surroundings all, List<Obstacle> obstacles) implements Surroundings {
    @Override
    public List<Segment> walls() {
      return all.walls();
    }

    @Override
    public List<Area> areas() {
      return all.areas();
    }
  }
}
