package org.maestro.bench.tracking;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.scene.Course;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.Stop;

/**
 * Evenings in which each person goes from room to room and stays in each for a while. Nine times
 * out of ten she goes where she usually goes from there, else anywhere; how long she stays is
 * exponentially distributed (assumed, both). Immutable.
 */
final class Evenings {
  private static final double USUAL = 0.9;
  private static final double MEAN_STAY_SECONDS = 240;
  private static final double SHORTEST_STAY_SECONDS = 30;
  private static final int STAYS = 40;

  /** What has more is passed through. */
  private static final int MOST_DOORS = 2;

  private final FloorWays ways;
  private final Scene scene;
  private final List<String> persons;

  /** Those in which one stays. */
  private final List<String> rooms;

  /**
   * @param scene what is so but for where persons are
   */
  Evenings(FloorWays ways, Scene scene, List<String> persons) {
    this.ways = ways;
    this.scene = scene;
    this.persons = List.copyOf(persons);
    this.rooms = ways.zones().stream().filter(zone -> ways.doorsOf(zone) <= MOST_DOORS).toList();
  }

  /** Whether one stays there. */
  boolean isRoom(String zone) {
    return rooms.contains(zone);
  }

  /** The evening of that seed; what is usual is the same on all of them. */
  Scene evening(long seed) {
    Random random = new Random(seed);
    Scene made = scene;
    Map<String, List<Stop>> walks = new TreeMap<>();
    for (String person : persons) {
      Map<String, String> usual = usual(person);
      String room = any(random);
      Point2 begun = ways.middle(room);
      made = made.with(person, scene.of(person).at(new Position(begun.x(), begun.y(), 0)));
      List<Stop> stops = new ArrayList<>(List.of(new Stop(begun, stay(random))));
      for (int i = 0; i < STAYS; i++) {
        String next = random.nextDouble() < USUAL ? usual.getOrDefault(room, room) : any(random);
        if (!next.equals(room)) {
          List<Point2> corners = ways.way(room, next);
          corners.subList(0, corners.size() - 1).forEach(c -> stops.add(new Stop(c, 0)));
          stops.add(new Stop(corners.get(corners.size() - 1), stay(random)));
          room = next;
        }
      }
      walks.put(person, stops);
    }
    return new Scene(
        made.name(),
        made.entries(),
        made.sky(),
        made.openings(),
        new Course(
            scene.course().faults(), walks, scene.course().roams(), scene.course().sayings()),
        made.states());
  }

  private Map<String, String> usual(String person) {
    Random random = new Random(persons.indexOf(person));
    Map<String, String> usual = new TreeMap<>();
    for (String room : rooms) {
      List<String> others = rooms.stream().filter(other -> !other.equals(room)).toList();
      usual.put(room, others.get(random.nextInt(others.size())));
    }
    return usual;
  }

  private String any(Random random) {
    return rooms.get(random.nextInt(rooms.size()));
  }

  private static double stay(Random random) {
    return Math.max(SHORTEST_STAY_SECONDS, -MEAN_STAY_SECONDS * Math.log(1 - random.nextDouble()));
  }
}
