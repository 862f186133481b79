package org.maestro.random;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.floor.Segment;

/** Rooms, walls and doors, and what can be seen and lit through them. */
final class Floor {
  private static final double COVERED_SHARE = 0.97;
  private static final double SAMPLE_METRES = 0.2;
  private static final double INSIDE = 0.01;

  private final Site site;
  private final Map<String, Polygon> zones = new TreeMap<>();
  private final Map<String, Segment> doors = new TreeMap<>();
  private final Map<String, Position> locations = new TreeMap<>();
  private final List<Polygon> rooms = new ArrayList<>();

  Floor(Site site) {
    this.site = site;
    site.of("Room").forEach(room -> rooms.add(Polygon.parse(site.text(room, "outline"))));
    site.of("Zone").forEach(zone -> zones.put(zone, Polygon.parse(site.text(zone, "outline"))));
    site.of("Location").forEach(name -> locations.put(name, site.position(name, "referencePoint")));
    for (String door : site.of("Door")) {
      doors.put(door, new Segment(site.point(door, "openingFrom"), site.point(door, "openingTo")));
    }
  }

  Collection<String> zones() {
    return zones.keySet();
  }

  Collection<String> doors() {
    return doors.keySet();
  }

  boolean isZone(String name) {
    return zones.containsKey(name);
  }

  Polygon outline(String zone) {
    return Objects.requireNonNull(zones.get(zone));
  }

  /** Where the light of each zone and desk is measured. */
  Map<String, Position> locations() {
    return Map.copyOf(locations);
  }

  /** The darkest places of a zone, of which a camera tells when it cannot see all of it. */
  List<Position> corners(String zone) {
    Polygon outline = outline(zone);
    Point2 middle = outline.centroid();
    return outline.corners().stream()
        .map(corner -> Position.onFloor(between(corner, middle)))
        .toList();
  }

  /** Just inside: nothing is seen through the corner of a wall. */
  private static Point2 between(Point2 corner, Point2 middle) {
    return new Point2(
        corner.x() + INSIDE * (middle.x() - corner.x()),
        corner.y() + INSIDE * (middle.y() - corner.y()));
  }

  /** All places of which the light is judged. */
  List<Position> litPlaces() {
    List<Position> places = new ArrayList<>(locations.values());
    zones.keySet().forEach(zone -> places.addAll(corners(zone)));
    return places;
  }

  Position location(String name) {
    return Objects.requireNonNull(locations.get(name));
  }

  /** The zone around it, or itself. */
  String zoneOf(String location) {
    return zoneAt(location(location).floor()).orElseThrow();
  }

  /** How far a place is from a zone; 0 within it. */
  double distance(String zone, Position place) {
    return outline(zone).contains(place.floor()) ? 0 : borderDistance(zone, place);
  }

  /** How far it is from the border of the zone, on either side. */
  double borderDistance(String zone, Position place) {
    return outline(zone).edges().stream()
        .mapToDouble(edge -> edge.distance(place.floor()))
        .min()
        .orElseThrow();
  }

  FloorPlan plan(Collection<String> openDoors) {
    return new FloorPlan(rooms, openDoors.stream().map(doors::get).toList());
  }

  boolean sees(String camera, Position place, Collection<String> openDoors) {
    Pose pose = site.pose(camera);
    return pose.angleTo(place.x(), place.y(), place.z()) <= site.number(camera, "viewAngle") / 2
        && !plan(openDoors).isBlocked(pose.floor(), place.floor());
  }

  /** Whether the camera has nearly all of the zone in view, doors shut. */
  boolean covers(String camera, String zone) {
    List<Point2> samples = outline(zone).samples(SAMPLE_METRES);
    long seen = samples.stream().filter(p -> sees(camera, Position.onFloor(p), List.of())).count();
    return seen >= COVERED_SHARE * samples.size();
  }

  Optional<String> zoneAt(Point2 point) {
    return zones.entrySet().stream()
        .filter(zone -> zone.getValue().contains(point))
        .map(Map.Entry::getKey)
        .findFirst();
  }
}
