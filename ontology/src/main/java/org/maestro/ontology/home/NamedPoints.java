package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.vocabulary.ClassDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.Point;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * The points that a statement names by their coordinates, which are things of a home as long as
 * somebody speaks of them: locations of which the light can be reckoned, and beside which something
 * can be put down (Three-layered architecture, 1; M5). Immutable.
 */
public record NamedPoints(Set<Point> points) {
  public static final NamedPoints NONE = new NamedPoints(Set.of());

  /** The class of points. */
  public static final String CLASS = "Point";

  private static final double IN_A_WALL_METRES = 1e-3;

  public NamedPoints {
    points = Set.copyOf(points);
  }

  /** Those of a goal, a question or a condition. */
  public static NamedPoints of(Formula formula) {
    Set<Point> found = new LinkedHashSet<>();
    Consumer<Term> names =
        term -> {
          if (term instanceof Term.Name name) {
            Point.named(name.text()).ifPresent(found::add);
          }
        };
    Leaves.of(
        formula,
        atom -> atom.arguments().forEach(names),
        fluent -> fluent.arguments().forEach(names));
    return found.isEmpty() ? NONE : new NamedPoints(found);
  }

  public boolean isEmpty() {
    return points.isEmpty();
  }

  /** The home in which they are things, too. */
  public Home in(Home home) {
    Map<String, Individual> things = new TreeMap<>(home.individuals());
    points.forEach(
        point ->
            things.putIfAbsent(point.name(), individual(point, home.iri(), home.vocabulary())));
    return things.size() == home.individuals().size() ? home : home.knownAs(things, home.wording());
  }

  /** The home without them. */
  public Home notIn(Home home) {
    Map<String, Individual> things = new TreeMap<>(home.individuals());
    points.forEach(point -> things.remove(point.name()));
    return home.knownAs(things, home.wording());
  }

  /** The point as a thing of the home of that IRI. */
  static Individual individual(Point point, String home, Vocabulary vocabulary) {
    Set<String> classes =
        Optional.ofNullable(vocabulary.classes().get(CLASS))
            .map(ClassDeclaration::ancestors)
            .orElse(Set.of(CLASS));
    return new Individual(
        point.name(),
        home + "#" + point.name(),
        "(" + point.coordinates() + ")",
        classes,
        Map.of("position", List.of(new Term.Text(point.coordinates()))));
  }

  /** Why one of them can be nowhere in the home. */
  public Optional<Contradiction> objection(Home home) {
    if (points.isEmpty()) {
      return Optional.empty();
    }
    Geometry geometry = new Geometry(home);
    return points.stream()
        .sorted(Comparator.comparing(Point::name))
        .flatMap(
            point ->
                objection(point, home, geometry)
                    .map(
                        found ->
                            new Contradiction(
                                "names (at %s), which %s"
                                    .formatted(point.coordinates(), found.problem()),
                                found.cure()))
                    .stream())
        .findFirst();
  }

  private static Optional<Contradiction> objection(Point point, Home home, Geometry geometry) {
    Individual other = home.individuals().get(point.name());
    Point2 floor = new Point2(point.x(), point.y());
    List<Individual> zones = home.of("Zone");
    List<Individual> around = containing(zones, floor, geometry);
    if (other != null && !other.classes().contains(CLASS)) {
      return refused("is what another thing is called", "give that thing another name");
    } else if (isInAWall(floor, home, geometry)) {
      return refused("lies in a wall", "name a point beside it");
    } else if (around.isEmpty()) {
      return refused(
          "lies outside of all zones", "name a point within one" + nearest(zones, floor, geometry));
    } else if (around.size() > 1) {
      String both = around.stream().map(Individual::name).collect(Collectors.joining(" and "));
      return refused("lies on the border of " + both, "name a point within one of them");
    }
    return isUnderTheCeiling(point, containing(home.of("Room"), floor, geometry))
        ? Optional.empty()
        : refused(
            "lies below the floor or above the ceiling",
            "correct the third number, the height in metres");
  }

  private static Optional<Contradiction> refused(String problem, String cure) {
    return Optional.of(new Contradiction(problem, cure));
  }

  private static List<Individual> containing(
      Collection<Individual> places, Point2 floor, Geometry geometry) {
    return places.stream()
        .filter(
            place -> geometry.outline(place.name()).filter(its -> its.contains(floor)).isPresent())
        .toList();
  }

  /** Rooms' outlines are walls but for their doors; what stands free is solid. */
  private static boolean isInAWall(Point2 floor, Home home, Geometry geometry) {
    List<Polygon> solid = new ArrayList<>();
    home.of("Room").forEach(room -> geometry.outline(room.name()).ifPresent(solid::add));
    List<Segment> openings =
        home.individuals().values().stream()
            .flatMap(one -> Geometry.opening(one).stream())
            .toList();
    return !containing(home.of("Wall"), floor, geometry).isEmpty()
        || new FloorPlan(solid, openings)
            .walls().stream().anyMatch(wall -> wall.distance(floor) < IN_A_WALL_METRES);
  }

  private static boolean isUnderTheCeiling(Point point, List<Individual> rooms) {
    double ceiling =
        rooms.stream()
            .flatMap(room -> room.values("height").stream())
            .filter(Term.Number.class::isInstance)
            .mapToDouble(height -> ((Term.Number) height).value())
            .max()
            .orElse(Double.POSITIVE_INFINITY);
    return point.z() >= 0 && point.z() <= ceiling;
  }

  private static String nearest(List<Individual> zones, Point2 floor, Geometry geometry) {
    return zones.stream()
        .filter(zone -> geometry.outline(zone.name()).isPresent())
        .min(Comparator.comparingDouble(zone -> middle(zone, geometry).distance(floor)))
        .map(
            zone ->
                ": %s, the nearest, has its middle at (at %s %s)"
                    .formatted(
                        zone.name(),
                        SlPrinter.print(middle(zone, geometry).x()),
                        SlPrinter.print(middle(zone, geometry).y())))
        .orElse("");
  }

  private static Point2 middle(Individual zone, Geometry geometry) {
    return geometry.outline(zone.name()).orElseThrow().centroid();
  }
}
