package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.apache.jena.graph.NodeFactory;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** What on the map of a home stands where it serves nobody, or where nobody comes. */
final class MapDoubts {

  private static final double SAMPLE_SPACING = 0.1;

  private final SourceGraph graph;
  private final Home home;
  private final Geometry geometry;
  private final List<Individual> rooms;
  private final List<Individual> zones;
  private final List<Fault> found = new ArrayList<>();

  MapDoubts(SourceGraph graph, Home home) {
    this.graph = graph;
    this.home = home;
    this.geometry = new Geometry(home);
    this.rooms = home.of("Room");
    this.zones = home.of("Zone");
  }

  List<Fault> found() {
    zones.forEach(this::checkRoom);
    zones.forEach(this::checkWays);
    home.devices().values().forEach(device -> checkPlace(device.individual()));
    home.devices().values().forEach(device -> checkView(device.individual()));
    home.of("Door").forEach(this::checkSides);
    return found;
  }

  /** A zone may lie outdoors, but not partly so, and not in two rooms. */
  private void checkRoom(Individual zone) {
    List<Point2> floor = outline(zone).samples(SAMPLE_SPACING);
    List<Individual> around =
        rooms.stream().filter(room -> floor.stream().anyMatch(outline(room)::contains)).toList();
    boolean isWithinOne =
        around.stream().anyMatch(room -> floor.stream().allMatch(outline(room)::contains));
    if (!around.isEmpty() && !isWithinOne) {
      warn(
          zone,
          "outline",
          "reaches beyond the walls of " + around.get(0).name(),
          "draw it within one room");
    }
  }

  private void checkWays(Individual zone) {
    boolean isCutOff =
        zones.size() > 1
            && zones.stream()
                .filter(other -> !other.equals(zone))
                .allMatch(
                    other ->
                        geometry
                            .shortestPath(zone.name(), other.name(), Positions.UNKNOWN)
                            .isEmpty());
    if (isCutOff) {
      warn(
          zone,
          "outline",
          "is cut off, as no way leads from there to any other zone",
          "add a maestro:Door to its room, or correct one");
    }
  }

  /** Where a fixed device stands or hangs. */
  private void checkPlace(Individual device) {
    for (Pose pose : poses(device)) {
      Optional<Individual> room =
          rooms.stream().filter(one -> outline(one).contains(pose.floor())).findFirst();
      boolean isOnTheMap =
          room.isPresent()
              || home.of("Location").stream()
                  .flatMap(place -> geometry.outline(place.name()).stream())
                  .anyMatch(place -> place.contains(pose.floor()));
      if (!isOnTheMap) {
        warn(
            device,
            "pose",
            "lies in no room, zone or other location of this home",
            "correct it, or draw a maestro:Zone there");
      }
      room.map(one -> height(one).orElse(Double.MAX_VALUE))
          .filter(height -> pose.z() > height + Segment.TOLERANCE || pose.z() < 0)
          .ifPresent(
              height ->
                  warn(
                      device,
                      "pose",
                      "is %s of %s"
                          .formatted(
                              pose.z() < 0
                                  ? "below the floor"
                                  : "above the ceiling, at %s m,"
                                      .formatted(SlPrinter.print(height)),
                              room.get().name()),
                      "correct its third number, the height above the floor"));
    }
  }

  private void checkView(Individual device) {
    if (poses(device).isEmpty() || device.values("viewAngle").isEmpty() || zones.isEmpty()) {
      return;
    }
    double best = 0;
    for (Individual zone : zones) {
      OptionalDouble share = geometry.viewShare(device.name(), zone.name(), Positions.UNKNOWN);
      best = Math.max(best, share.orElse(0));
    }
    if (best < MapCheck.WATCHED_SHARE) {
      warn(
          device,
          "viewAngle",
          "is too narrow where it is: it sees at most %d %% of a zone, and to look there takes 95 %%"
              .formatted(Math.round(100 * best)),
          "widen it, correct maestro:pose, or divide the zone");
    }
  }

  /** Zones that a door is said to have at its sides lie in rooms whose wall it opens. */
  private void checkSides(Individual door) {
    for (Segment opening : Geometry.opening(door).stream().toList()) {
      for (PredicateDeclaration word : home.vocabulary().predicates().values()) {
        if (isOfDoorAndZone(word)) {
          for (Term side : door.values(word.name())) {
            checkSide(door, opening, word, side);
          }
        }
      }
    }
  }

  private static boolean isOfDoorAndZone(PredicateDeclaration word) {
    return word.parameters().stream()
        .map(TypedVariable::className)
        .toList()
        .equals(List.of(Optional.of("Door"), Optional.of("Zone")));
  }

  private void checkSide(Individual door, Segment opening, PredicateDeclaration word, Term side) {
    if (!(side instanceof Term.Name zone) || geometry.outline(zone.text()).isEmpty()) {
      return;
    }
    Polygon outline = geometry.outline(zone.text()).get();
    List<Individual> around =
        rooms.stream()
            .filter(
                room -> outline.samples(SAMPLE_SPACING).stream().anyMatch(outline(room)::contains))
            .toList();
    if (!around.isEmpty()
        && around.stream()
            .noneMatch(
                room -> outline(room).edges().stream().anyMatch(edge -> edge.covers(opening)))) {
      found.add(
          graph.told(
              NodeFactory.createURI(door.iri()),
              NodeFactory.createURI(word.iri()),
              Optional.of(
                  NodeFactory.createURI(HomeCheck.named(home.individuals(), zone.text()).iri())),
              "lies in no room in whose wall the door is",
              "name the zones before and behind the door"));
    }
  }

  private static List<Pose> poses(Individual device) {
    return device.values("pose").stream()
        .filter(Term.Text.class::isInstance)
        .map(text -> Pose.parse(((Term.Text) text).value()))
        .toList();
  }

  private static Optional<Double> height(Individual room) {
    return room.values("height").stream()
        .filter(Term.Number.class::isInstance)
        .map(number -> ((Term.Number) number).value())
        .findFirst();
  }

  private Polygon outline(Individual place) {
    return geometry.outline(place.name()).orElseThrow();
  }

  private void warn(Individual thing, String property, String problem, String cure) {
    found.add(
        graph.told(
            NodeFactory.createURI(thing.iri()),
            Maestro.term(property),
            Optional.empty(),
            problem,
            cure));
  }
}
