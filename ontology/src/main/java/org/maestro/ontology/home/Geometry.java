package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.floor.WayFinder;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The closed list of geometry functions over a home: {@code distance}, {@code inside}, {@code
 * viewShare}, {@code luxAt}, {@code daylightShare}, {@code sunlightShare}, {@code shortestPath} and
 * {@code floorArea}. They ask for properties such as pose and view angle, never for a kind of
 * device. Fixed devices stand where the home says, movable things where {@link Positions} says.
 * Doors let robots through; light and sight through them are not counted on. Safe for threads.
 */
public final class Geometry {

  /** Spacing of the points at which a zone's view is sampled; metres. */
  private static final double SAMPLE_SPACING = 0.1;

  private static final double HEMISPHERE_DEGREES = 180;
  private static final double ROUNDING_DEGREES = 1e-6;

  private static final String FLOOR_AREA = "floorArea";
  private static final String ELEVATION = "elevation";

  private final Map<String, Individual> individuals;
  private final Map<String, Polygon> outlines = new TreeMap<>();
  private final Map<String, Pose> fixed = new TreeMap<>();
  private final FloorPlan closed;
  private final Windows windows;
  private final WayFinder ways;
  private final Map<Sight, Double> viewShares = new ConcurrentHashMap<>();
  private final Map<Segment, OptionalDouble> fixedWays = new ConcurrentHashMap<>();
  private final Map<String, Optional<Pose>> referencePoints = new ConcurrentHashMap<>();
  private final Map<Pair, OptionalDouble> fixedLux = new ConcurrentHashMap<>();
  private final Map<Pair, OptionalDouble> daylightShares = new ConcurrentHashMap<>();
  private final Map<Pair, OptionalDouble> sunlightShares = new ConcurrentHashMap<>();

  /** A device and a location to which it gives light; both stay where the home says. */
  private record Pair(String device, String location) {}

  private record Sight(Pose pose, double viewAngle, String zone) {}

  /**
   * @param home its poses and outlines are well-formed, as the loader makes sure
   */
  public Geometry(Home home) {
    this.individuals = home.individuals();
    List<Polygon> solid = new ArrayList<>();
    List<Segment> openings = new ArrayList<>();
    for (Individual individual : individuals.values()) {
      text(individual, "outline")
          .map(Polygon::parse)
          .ifPresent(o -> outlines.put(individual.name(), o));
      text(individual, "pose")
          .or(() -> text(individual, "position"))
          .map(Pose::parse)
          .ifPresent(pose -> fixed.put(individual.name(), pose));
      if (individual.classes().contains("Room") || individual.classes().contains("Wall")) {
        Optional.ofNullable(outlines.get(individual.name())).ifPresent(solid::add);
      }
      opening(individual).ifPresent(openings::add);
    }
    this.closed = new FloorPlan(solid, List.of());
    this.windows = new Windows(home);
    this.ways = new WayFinder(new FloorPlan(solid, openings), solid, openings);
  }

  /** Whether a function of this name gives a number. */
  public static boolean isNumber(String function) {
    return List.of(
            "distance",
            "viewShare",
            "luxAt",
            "daylightShare",
            "sunlightShare",
            "shortestPath",
            FLOOR_AREA,
            ELEVATION)
        .contains(function);
  }

  /** Whether a function of this name gives a truth value. */
  public static boolean isTruth(String function) {
    return function.equals("inside");
  }

  /** A door's opening, when the home states it. */
  public static Optional<Segment> opening(Individual door) {
    return text(door, "openingFrom")
        .flatMap(from -> text(door, "openingTo").map(to -> new Segment(point(from), point(to))));
  }

  /** The outline of a room, zone or wall. */
  public Optional<Polygon> outline(String name) {
    return Optional.ofNullable(outlines.get(name));
  }

  /**
   * The value of a function with two arguments, or one for a floor's area and an elevation, as
   * formulas write it.
   *
   * @return empty when a position is unknown or the function is none of numbers
   */
  public OptionalDouble number(String function, List<Term> arguments, Positions positions) {
    if (function.equals(FLOOR_AREA)
        && arguments.size() == 1
        && arguments.get(0) instanceof Term.Name place) {
      return floorArea(place.text());
    }
    if (function.equals(ELEVATION)
        && arguments.size() == 1
        && arguments.get(0) instanceof Term.Name thing) {
      return pose(thing.text(), positions).stream().mapToDouble(Pose::z).findFirst();
    }
    if (arguments.size() != 2
        || !(arguments.get(0) instanceof Term.Name first)
        || !(arguments.get(1) instanceof Term.Name second)) {
      return OptionalDouble.empty();
    }
    return switch (function) {
      case "distance" -> distance(first.text(), second.text(), positions);
      case "viewShare" -> viewShare(first.text(), second.text(), positions);
      case "luxAt" -> luxAt(first.text(), second.text(), positions);
      case "daylightShare" -> daylightShare(first.text(), second.text());
      case "sunlightShare" -> sunlightShare(first.text(), second.text());
      case "shortestPath" -> shortestPath(first.text(), second.text(), positions);
      default -> OptionalDouble.empty();
    };
  }

  /** The truth of a function with two arguments; unknown when a position is. */
  public Truth truth(String function, List<Term> arguments, Positions positions) {
    if (isTruth(function)
        && arguments.size() == 2
        && arguments.get(0) instanceof Term.Name thing
        && arguments.get(1) instanceof Term.Name zone) {
      return inside(thing.text(), zone.text(), positions);
    }
    return Truth.UNKNOWN;
  }

  /** Square metres within an outline; empty for what has none. */
  public OptionalDouble floorArea(String place) {
    Polygon outline = outlines.get(place);
    return outline == null ? OptionalDouble.empty() : OptionalDouble.of(outline.area());
  }

  /** Horizontal distance in metres; of zones and rooms the middle counts. */
  public OptionalDouble distance(String a, String b, Positions positions) {
    Optional<Point2> from = floorPoint(a, positions);
    Optional<Point2> to = floorPoint(b, positions);
    return from.isPresent() && to.isPresent()
        ? OptionalDouble.of(from.get().distance(to.get()))
        : OptionalDouble.empty();
  }

  /**
   * Whether a thing, or a location's reference point, is within another's outline; false for a
   * location without outline.
   */
  public Truth inside(String thing, String zone, Positions positions) {
    Polygon outline = outlines.get(zone);
    if (outline == null) {
      return Truth.FALSE;
    }
    return pose(thing, positions)
        .or(() -> isLocation(thing) ? referencePoint(thing) : Optional.empty())
        .map(pose -> Truth.of(outline.contains(pose.floor())))
        .orElse(Truth.UNKNOWN);
  }

  /** The share, 0 to 1, of a zone's floor in a device's view; 0 without view angle. */
  public OptionalDouble viewShare(String device, String zone, Positions positions) {
    OptionalDouble angle = property(device, "viewAngle");
    Polygon outline = outlines.get(zone);
    if (angle.isEmpty() || outline == null) {
      return OptionalDouble.of(0);
    }
    Optional<Pose> pose = pose(device, positions);
    return pose.isEmpty()
        ? OptionalDouble.empty()
        : OptionalDouble.of(
            viewShares.computeIfAbsent(
                new Sight(pose.get(), angle.getAsDouble(), zone),
                sight -> viewShare(sight, outline)));
  }

  private double viewShare(Sight sight, Polygon outline) {
    if (isOutOfView(sight, outline)) {
      return 0;
    }
    List<Point2> samples = outline.samples(SAMPLE_SPACING);
    Pose pose = sight.pose();
    long seen =
        samples.stream()
            .filter(point -> pose.angleTo(point.x(), point.y(), 0) <= sight.viewAngle() / 2)
            .filter(point -> !closed.isBlocked(pose.floor(), point))
            .count();
    return samples.isEmpty() ? 0 : (double) seen / samples.size();
  }

  /** Whether even the circle around the outline is outside the angle of view: most zones are. */
  private static boolean isOutOfView(Sight sight, Polygon outline) {
    Pose pose = sight.pose();
    Point2 middle = outline.middle();
    double distance = Math.hypot(pose.floor().distance(middle), pose.z());
    return distance > outline.radius()
        && pose.angleTo(middle.x(), middle.y(), 0)
                - Math.toDegrees(Math.asin(outline.radius() / distance))
            > sight.viewAngle() / 2 + ROUNDING_DEGREES;
  }

  /**
   * What a source at full level adds at a location's reference point: I cos^3 / h^2 in lux; 0
   * outside its beam, behind walls, or without luminous intensity.
   */
  public OptionalDouble luxAt(String device, String location, Positions positions) {
    Optional<Pose> moved = positions.of(device);
    Optional<Pose> fixedAt = Optional.ofNullable(fixed.get(device));
    return moved.isPresent()
        ? luxFrom(moved, device, location)
        : fixedLux.computeIfAbsent(
            new Pair(device, location), pair -> luxFrom(fixedAt, device, location));
  }

  private OptionalDouble luxFrom(Optional<Pose> pose, String device, String location) {
    OptionalDouble intensity = property(device, "luminousIntensity");
    Optional<Pose> point = referencePoint(location);
    if (intensity.isEmpty() || point.isEmpty()) {
      return OptionalDouble.of(0);
    }
    if (pose.isEmpty()) {
      return OptionalDouble.empty();
    }
    Pose lamp = pose.get();
    Pose lit = point.get();
    double height = lamp.z() - lit.z();
    double beam = property(device, "beamAngle").orElse(HEMISPHERE_DEGREES);
    if (height <= 0
        || lamp.angleTo(lit.x(), lit.y(), lit.z()) > beam / 2
        || closed.isBlocked(lamp.floor(), lit.floor())) {
      return OptionalDouble.of(0);
    }
    double cosine = height / Math.hypot(height, lamp.floor().distance(lit.floor()));
    return OptionalDouble.of(
        intensity.getAsDouble() * cosine * cosine * cosine / (height * height));
  }

  /**
   * What a device that shades windows, opened wholly, lets in to a location's reference point: lux
   * for each lux that falls from all sides upon the outside of the glass; 0 for one that shades
   * none.
   */
  public OptionalDouble daylightShare(String device, String location) {
    return daylightShares.computeIfAbsent(
        new Pair(device, location),
        pair ->
            OptionalDouble.of(
                referencePoint(location)
                    .map(point -> windows.share(device, point.x(), point.y(), point.z(), closed))
                    .orElse(0.0)));
  }

  /**
   * The same for each lux that comes straight from the sun, where it does not shine upon the point
   * itself.
   */
  public OptionalDouble sunlightShare(String device, String location) {
    return sunlightShares.computeIfAbsent(
        new Pair(device, location),
        pair ->
            OptionalDouble.of(
                referencePoint(location)
                    .map(point -> windows.reflectedShare(device, point.floor()))
                    .orElse(0.0)));
  }

  /** Length in metres of the shortest way between two places; empty when there is none. */
  public OptionalDouble shortestPath(String a, String b, Positions positions) {
    Optional<Point2> from = floorPoint(a, positions);
    Optional<Point2> to = floorPoint(b, positions);
    return from.isPresent() && to.isPresent()
        ? length(from.get(), to.get(), outlines.containsKey(a) && outlines.containsKey(b))
        : OptionalDouble.empty();
  }

  /** Ways between what never moves are asked for again and again, and kept. */
  private OptionalDouble length(Point2 from, Point2 to, boolean fixedEnds) {
    return fixedEnds
        ? fixedWays.computeIfAbsent(new Segment(from, to), way -> ways.length(from, to))
        : ways.length(from, to);
  }

  /** Where a location's light is measured: as stated, at its position, or its outline's middle. */
  public Optional<Pose> referencePoint(String location) {
    return individuals.containsKey(location)
        ? referencePoints.computeIfAbsent(location, this::readReferencePoint)
        : Optional.empty();
  }

  private Optional<Pose> readReferencePoint(String location) {
    return Optional.ofNullable(individuals.get(location))
        .flatMap(individual -> text(individual, "referencePoint"))
        .map(Pose::parse)
        .or(() -> Optional.ofNullable(fixed.get(location)))
        .or(
            () ->
                outline(location)
                    .map(Polygon::centroid)
                    .map(middle -> new Pose(middle.x(), middle.y(), 0, 0, 0, 0)));
  }

  private Optional<Point2> floorPoint(String name, Positions positions) {
    return pose(name, positions)
        .map(Pose::floor)
        .or(() -> outline(name).map(Polygon::centroid))
        .or(
            () ->
                Optional.ofNullable(individuals.get(name))
                    .flatMap(Geometry::opening)
                    .map(Segment::middle));
  }

  private Optional<Pose> pose(String name, Positions positions) {
    return positions.of(name).or(() -> Optional.ofNullable(fixed.get(name)));
  }

  private boolean isLocation(String name) {
    return Optional.ofNullable(individuals.get(name))
        .filter(individual -> individual.classes().contains("Location"))
        .isPresent();
  }

  private OptionalDouble property(String name, String property) {
    Individual individual = individuals.get(name);
    if (individual != null) {
      for (Term value : individual.properties().getOrDefault(property, List.of())) {
        if (value instanceof Term.Number number) {
          return OptionalDouble.of(number.value());
        }
      }
    }
    return OptionalDouble.empty();
  }

  private static Optional<String> text(Individual individual, String property) {
    return individual.properties().getOrDefault(property, List.of()).stream()
        .filter(Term.Text.class::isInstance)
        .map(value -> ((Term.Text) value).value())
        .findFirst();
  }

  private static Point2 point(String text) {
    double[] numbers = Pose.numbers(text);
    return new Point2(numbers[0], numbers[1]);
  }
}
