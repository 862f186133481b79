package org.maestro.sim.world;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.hal.Area;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sim.scene.SimulationException;
import org.maestro.sl.Term;

/** The fixed part of the world, read from a home by the words of the meta-vocabulary. Immutable. */
public final class FloorMap {

  private final List<Polygon> walled;
  private final List<Area> rooms;
  private final List<Area> areas;
  private final Map<String, Segment> doors;

  public FloorMap(Home home) {
    List<Polygon> outlines = new ArrayList<>();
    List<Area> inRooms = new ArrayList<>();
    List<Area> zones = new ArrayList<>();
    Map<String, Segment> openings = new TreeMap<>();
    for (Individual individual : home.individuals().values()) {
      boolean room = individual.classes().contains("Room");
      if (room || individual.classes().contains("Wall")) {
        outlines.add(outline(individual));
      }
      if (room) {
        inRooms.add(area(individual));
      }
      if (individual.classes().contains("Zone")) {
        zones.add(area(individual));
      }
      if (individual.classes().contains("Door")) {
        openings.put(
            individual.name(),
            new Segment(corner(individual, "openingFrom"), corner(individual, "openingTo")));
      }
    }
    this.walled = List.copyOf(outlines);
    this.rooms = List.copyOf(inRooms);
    this.areas = List.copyOf(zones.isEmpty() ? inRooms : zones);
    this.doors = Collections.unmodifiableMap(openings);
  }

  public List<Area> areas() {
    return areas;
  }

  /**
   * @throws SimulationException when there is no such area
   */
  public Area area(String name) {
    return areas.stream()
        .filter(area -> area.name().equals(name))
        .findFirst()
        .orElseThrow(() -> new SimulationException("There is no zone " + name + " in this home."));
  }

  public Map<String, Segment> doors() {
    return doors;
  }

  /** Whether a point lies in a room. */
  boolean isIndoors(Point2 point) {
    return rooms.stream().anyMatch(room -> room.outline().contains(point));
  }

  public Optional<Area> areaAt(Point2 point) {
    return areas.stream().filter(area -> area.outline().contains(point)).findFirst();
  }

  /** Walls with openings where doors are open. */
  public FloorPlan plan(Set<String> openDoors) {
    return new FloorPlan(
        walled, doors.keySet().stream().filter(openDoors::contains).map(doors::get).toList());
  }

  /** The same walls, each once, by the doors that are closed. */
  public List<Segment> walls(Set<String> closedDoors) {
    Set<String> open = new TreeSet<>(doors.keySet());
    open.removeAll(closedDoors);
    return walls(plan(open));
  }

  /** Each wall once, though it may bound two rooms. */
  static List<Segment> walls(FloorPlan plan) {
    Set<Segment> once = new LinkedHashSet<>();
    for (Segment wall : plan.walls()) {
      if (!once.contains(new Segment(wall.to(), wall.from()))) {
        once.add(wall);
      }
    }
    return List.copyOf(once);
  }

  public static Optional<Pose> pose(Individual individual, String property) {
    return text(individual, property).map(Pose::parse);
  }

  public static OptionalDouble number(Individual individual, String property) {
    return individual.properties().getOrDefault(property, List.of()).stream()
        .filter(Term.Number.class::isInstance)
        .mapToDouble(term -> ((Term.Number) term).value())
        .findFirst();
  }

  /** Two numbers, as in {@code "1920 1080"}. */
  public static Optional<Point2> pair(Individual individual, String property) {
    return text(individual, property).map(text -> corner(individual, property));
  }

  private static Optional<String> text(Individual individual, String property) {
    return individual.properties().getOrDefault(property, List.of()).stream()
        .filter(Term.Text.class::isInstance)
        .map(term -> ((Term.Text) term).value())
        .findFirst();
  }

  private static Polygon outline(Individual individual) {
    return Polygon.parse(required(individual, "outline"));
  }

  private static Area area(Individual individual) {
    Polygon outline = outline(individual);
    Point2 reference =
        pose(individual, "referencePoint").map(Pose::floor).orElseGet(outline::centroid);
    return new Area(individual.name(), outline, reference);
  }

  private static Point2 corner(Individual individual, String property) {
    String[] numbers = required(individual, property).strip().split("\\s+");
    return new Point2(Double.parseDouble(numbers[0]), Double.parseDouble(numbers[1]));
  }

  private static String required(Individual individual, String property) {
    return text(individual, property)
        .orElseThrow(
            () ->
                new SimulationException(
                    individual.name()
                        + " has no maestro:"
                        + property
                        + ", without which it cannot be simulated. Add it to the home file."));
  }
}
