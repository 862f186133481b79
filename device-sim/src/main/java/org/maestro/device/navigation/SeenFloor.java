package org.maestro.device.navigation;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.maestro.hal.Area;
import org.maestro.hal.Position;
import org.maestro.hal.RangeFinder;
import org.maestro.hal.Surroundings;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;
import org.maestro.rats.time.Clock;

/**
 * The floor as one robot has seen it: the rooms' plan, which it was given, and the bodies and doors
 * that its range finder showed it on its way, as they were when it saw them last. A door that it
 * never saw stands open to it. Clock thread only.
 */
public final class SeenFloor implements Surroundings {

  /** Just before and just behind a door: who sees but one of both sees that it is closed. */
  private static final double BESIDE_DOOR_METRES = 0.02;

  /** A body that is seen so far from where it was has moved. */
  private static final double MOVED_METRES = 0.1;

  private final Plan plan;
  private final RangeFinder finder;
  private final Clock clock;
  private final Duration memory;
  private final Map<String, Sighting> sightings = new TreeMap<>();
  private final Set<String> closed = new TreeSet<>();
  private final Set<String> seenClosed = new TreeSet<>();
  private Walls known;
  private Walls certain;

  /**
   * The fixed part of the floor.
   *
   * @param doors openings, by name
   * @param walls with openings where doors are open, by the names of those that are closed
   */
  public record Plan(
      List<Area> areas, Map<String, Segment> doors, Function<Set<String>, List<Segment>> walls) {}

  /**
   * Where a body was seen last.
   *
   * @param moves whether it was ever seen elsewhere before
   */
  private record Sighting(Obstacle body, Duration at, boolean moves) {}

  private record Walls(Set<String> closed, List<Segment> segments) {}

  /**
   * @param memory for how long a body that moves is taken to be where it was seen
   */
  public SeenFloor(Plan plan, RangeFinder finder, Clock clock, Duration memory) {
    this.plan = plan;
    this.finder = finder;
    this.clock = clock;
    this.memory = memory;
    this.known = walls(Set.of());
    this.certain = known;
  }

  private Walls walls(Set<String> without) {
    return new Walls(Set.copyOf(without), plan.walls().apply(without));
  }

  /** Takes note of what can be seen now; to be called as often as the robot moves on a little. */
  public void look() {
    lookAtDoors();
    Map<String, Obstacle> seen =
        finder.bodies().stream().collect(Collectors.toMap(Obstacle::name, body -> body));
    sightings.values().removeIf(last -> !seen.containsKey(last.body().name()) && isGone(last));
    seen.forEach((name, body) -> sightings.put(name, sighting(body)));
  }

  private void lookAtDoors() {
    seenClosed.clear();
    plan.doors()
        .forEach(
            (door, opening) -> {
              boolean before = finder.sees(beside(opening, BESIDE_DOOR_METRES));
              boolean behind = finder.sees(beside(opening, -BESIDE_DOOR_METRES));
              if (before && behind) {
                closed.remove(door);
              } else if (before || behind) {
                closed.add(door);
                seenClosed.add(door);
              }
            });
  }

  private static Position beside(Segment opening, double metres) {
    Point2 middle = opening.middle();
    double share = metres / opening.length();
    return new Position(
        middle.x() - share * (opening.to().y() - opening.from().y()),
        middle.y() + share * (opening.to().x() - opening.from().x()),
        0);
  }

  private boolean isGone(Sighting last) {
    return finder.sees(Position.onFloor(last.body().middle()))
        || last.moves() && clock.now().minus(last.at()).compareTo(memory) > 0;
  }

  private Sighting sighting(Obstacle body) {
    Sighting last = sightings.get(body.name());
    boolean moves =
        last != null
            && (last.moves() || last.body().middle().distance(body.middle()) > MOVED_METRES);
    return new Sighting(body, clock.now(), moves);
  }

  @Override
  public List<Segment> walls() {
    look();
    if (!known.closed().equals(closed)) {
      known = walls(closed);
    }
    return known.segments();
  }

  @Override
  public List<Obstacle> obstacles() {
    look();
    return sightings.values().stream().map(Sighting::body).toList();
  }

  @Override
  public List<Area> areas() {
    return plan.areas();
  }

  @Override
  public boolean sees(Position place) {
    return finder.sees(place);
  }

  @Override
  public Surroundings inView() {
    look();
    if (seenClosed.equals(known.closed())) {
      certain = known;
    } else if (!certain.closed().equals(seenClosed)) {
      certain = walls(seenClosed);
    }
    return new InView(certain.segments(), finder.bodies(), plan.areas());
  }

  private record InView(List<Segment> walls, List<Obstacle> obstacles, List<Area> areas)
      implements Surroundings {}
}
