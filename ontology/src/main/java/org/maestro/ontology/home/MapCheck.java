package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.apache.jena.graph.NodeFactory;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.sl.Term;

/**
 * Checks what only the whole map of a home shows: what overlaps, what is off its wall, what nobody
 * sees. Asks for well-formed poses and outlines.
 */
final class MapCheck {

  /** The share of a watched zone that one device alone has to see. */
  static final double WATCHED_SHARE = 0.95;

  private static final double SAMPLE_SPACING = 0.1;
  private static final double EDGE = 1e-3;

  private final SourceGraph graph;
  private final Home home;
  private final Geometry geometry;

  MapCheck(SourceGraph graph, Home home) {
    this.graph = graph;
    this.home = home;
    this.geometry = new Geometry(home);
  }

  /** What is wrong becomes faults of the graph. */
  void check() {
    home.individuals().values().forEach(this::checkOutline);
    if (!graph.faults().isEmpty()) {
      return;
    }
    List<Individual> zones = home.of("Zone");
    checkOverlaps(zones, "zone");
    checkOverlaps(home.of("Room").stream().filter(room -> !zones.contains(room)).toList(), "room");
    if (graph.faults().isEmpty()) {
      zones.stream()
          .filter(zone -> zone.values("watched").contains(new Term.Truth(true)))
          .forEach(this::checkWatched);
    }
    home.of("Location").forEach(this::checkReferencePoint);
    List<Segment> walls = walls();
    home.of("Door").forEach(door -> checkDoor(door, walls));
    home.individuals().values().forEach(this::checkWindows);
  }

  private void checkOutline(Individual thing) {
    geometry
        .outline(thing.name())
        .filter(outline -> !outline.isSimple())
        .ifPresent(
            outline ->
                fault(
                    thing,
                    "outline",
                    "crosses or touches itself",
                    "write the corners in the order in which one comes by them on the way around"));
  }

  private void checkOverlaps(List<Individual> places, String kind) {
    for (int i = 0; i < places.size(); i++) {
      for (int j = i + 1; j < places.size(); j++) {
        checkOverlap(places.get(i), places.get(j), kind);
      }
    }
  }

  private void checkOverlap(Individual a, Individual b, String kind) {
    Polygon first = geometry.outline(a.name()).orElseThrow();
    Polygon second = geometry.outline(b.name()).orElseThrow();
    boolean overlap =
        first.isNear(second)
            && first.samples(SAMPLE_SPACING).stream().anyMatch(point -> isWithin(second, point));
    if (overlap) {
      fault(
          b,
          "outline",
          "overlaps the " + kind + " " + a.name(),
          "draw the outlines so that they share at most an edge");
    }
  }

  private static boolean isWithin(Polygon outline, Point2 point) {
    return outline.contains(point)
        && outline.edges().stream().allMatch(edge -> edge.distance(point) > EDGE);
  }

  private void checkWatched(Individual zone) {
    double best = 0;
    for (String device : home.devices().keySet()) {
      OptionalDouble share = geometry.viewShare(device, zone.name(), Positions.UNKNOWN);
      best = Math.max(best, share.orElse(0));
    }
    if (best < WATCHED_SHARE) {
      fault(
          zone,
          "watched",
          "asks for a device that sees 95 % of the zone, and the best sees "
              + Math.round(100 * best)
              + " %",
          "move the device, widen its maestro:viewAngle, or divide the zone");
    }
  }

  private void checkReferencePoint(Individual location) {
    Optional<Polygon> outline = geometry.outline(location.name());
    boolean isOutside =
        !location.values("referencePoint").isEmpty()
            && outline.isPresent()
            && geometry
                .referencePoint(location.name())
                .filter(point -> !outline.get().contains(point.floor()))
                .isPresent();
    if (isOutside) {
      fault(
          location,
          "referencePoint",
          "lies outside of its maestro:outline",
          "write a point within, at which its light is to be measured");
    }
  }

  private void checkDoor(Individual door, List<Segment> walls) {
    Geometry.opening(door)
        .ifPresent(
            opening -> {
              if (opening.length() <= Segment.TOLERANCE) {
                fault(
                    door,
                    "openingTo",
                    "is where the opening begins, so that nobody comes through",
                    "write the other end of the opening");
              } else if (!walls.isEmpty()
                  && walls.stream().noneMatch(wall -> wall.covers(opening))) {
                fault(
                    door,
                    "openingFrom",
                    "begins an opening that lies in no wall of a room",
                    "put both ends of the opening on one and the same edge of a room's"
                        + " maestro:outline");
              }
            });
  }

  private List<Segment> walls() {
    List<Segment> walls = new ArrayList<>();
    for (String kind : List.of("Room", "Wall")) {
      home.of(kind)
          .forEach(
              one -> geometry.outline(one.name()).ifPresent(shape -> walls.addAll(shape.edges())));
    }
    return walls;
  }

  private void checkWindows(Individual thing) {
    if (thing.classes().contains("Window")) {
      Windows.misplacement(thing, home)
          .ifPresent(
              wrong ->
                  fault(
                      thing,
                      "glassFrom",
                      wrong,
                      "put its lower corner and the opposite upper one on an outer wall of one"
                          + " room"));
    }
    for (Term shaded : thing.values("shades")) {
      boolean isWindow =
          shaded instanceof Term.Name name
              && Optional.ofNullable(home.individuals().get(name.text()))
                  .filter(other -> other.classes().contains("Window"))
                  .isPresent();
      if (!isWindow) {
        fault(thing, "shades", "names no window of this home", "name a maestro:Window");
      }
    }
  }

  private void fault(Individual thing, String property, String problem, String cure) {
    graph.fault(
        NodeFactory.createURI(thing.iri()),
        Maestro.term(property),
        Optional.empty(),
        problem,
        cure);
  }
}
