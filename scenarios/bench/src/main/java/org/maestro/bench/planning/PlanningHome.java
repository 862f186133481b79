package org.maestro.bench.planning;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;

/**
 * A random home as a planning problem: of each 100 agents some 50 are lamps, 16 cameras, 12 light
 * sensors, 10 doors, 8 shutters and 4 robots, in 12 rooms with 8 things to carry. The rooms form a
 * tree with a few more ways, of which every third has a door. The light that is asked for can be
 * had with one lamp; whether a transport can be done is left to chance.
 */
final class PlanningHome {
  /** A goal to be planned for. */
  enum Wish {
    OBSERVE,
    ILLUMINATE,
    TRANSPORT,
    THREE_TRANSPORTS;

    String words() {
      return name().toLowerCase(Locale.ROOT).replace('_', ' ');
    }
  }

  private final Random random;
  private final int agents;
  private final StringBuilder objects = new StringBuilder();
  private final TreeSet<String> facts = new TreeSet<>();
  private final List<Integer> roomsOfPersons = new ArrayList<>();
  private final List<Integer> levels = new ArrayList<>();

  /** What each lamp adds: the first ones, of each room one, are off. */
  private final List<Integer> gains = new ArrayList<>();

  private int items;
  private int persons;

  PlanningHome(int agents, long seed) {
    this.agents = agents;
    this.random = new Random(seed);
  }

  /** The problem's text; the domain is the resource {@code /planning/home-domain.pddl}. */
  String problem(Wish wish) {
    objects.setLength(0);
    facts.clear();
    roomsOfPersons.clear();
    levels.clear();
    gains.clear();
    int rooms = share(12, 2);
    object("lux-level", "l", 6);
    object("room", "r", rooms);
    object("kind", "kind", 2);
    object("grip", "grip", 3);
    addRooms(rooms);
    addLight(rooms);
    addEyes(rooms);
    addThings(rooms);
    addRobots(rooms);
    return "(define (problem home)\n (:domain home)\n (:objects%s)\n (:init (= (total-cost) 0)\n  %s)\n (:goal (and %s))\n (:metric minimize (total-cost)))\n"
        .formatted(objects, String.join("\n  ", facts), goal(wish));
  }

  private String goal(Wish wish) {
    int item = random.nextInt(items);
    return switch (wish) {
      case OBSERVE -> "(located item%d)".formatted(item);
      case ILLUMINATE -> {
        int room = roomsOfPersons.get(0);
        yield "(known-level r%d l%d)".formatted(room, levels.get(room) + gains.get(room));
      }
      case TRANSPORT -> next(item);
      case THREE_TRANSPORTS -> next(item) + next((item + 1) % items) + next((item + 2) % items);
    };
  }

  private String next(int item) {
    return "(next-to item%d person%d)".formatted(item, random.nextInt(persons));
  }

  private int share(int percent, int atLeast) {
    return Math.max(atLeast, agents * percent / 100);
  }

  private void object(String type, String prefix, int count) {
    for (int i = 0; i < count; i++) {
      objects.append(' ').append(prefix).append(i);
    }
    if (count > 0) {
      objects.append(" - ").append(type);
    }
  }

  private void fact(String form, Object... values) {
    facts.add("(" + String.format(Locale.ROOT, form, values) + ")");
  }

  private int between(int least, int most) {
    return least + random.nextInt(most - least + 1);
  }

  private void addRooms(int rooms) {
    int doors = share(10, 0);
    int door = 0;
    Set<Set<Integer>> ways = new HashSet<>();
    for (int room = 1; room < rooms + rooms / 6; room++) {
      int here = room < rooms ? room : random.nextInt(rooms);
      int there = room < rooms ? random.nextInt(room) : random.nextInt(rooms);
      if (here == there || !ways.add(Set.of(here, there))) {
        continue;
      }
      int length = between(2, 9);
      for (int kind = 0; kind < 2; kind++) {
        fact("= (move-cost kind%d r%d r%d) %d", kind, here, there, length * (kind + 1));
        fact("= (move-cost kind%d r%d r%d) %d", kind, there, here, length * (kind + 1));
      }
      boolean hasDoor = door < doors && random.nextInt(3) == 0;
      boolean shut = hasDoor && random.nextBoolean();
      if (hasDoor) {
        fact("online door%d", door);
        fact("unlocked door%d", door);
        fact("door-between door%d r%d r%d", door, here, there);
        fact(shut ? "shut door%d" : "ajar door%d", door);
        fact("= (door-cost door%d) %d", door, between(1, 4));
        door++;
      }
      if (!shut) {
        fact("passable r%d r%d", here, there);
        fact("passable r%d r%d", there, here);
      }
    }
    object("door", "door", door);
  }

  private void addLight(int rooms) {
    int lights = share(50, rooms);
    object("light", "light", lights);
    for (int light = 0; light < lights; light++) {
      fact("online light%d", light);
      fact("light-in light%d r%d", light, light % rooms);
      boolean on = random.nextInt(5) == 0 && light >= rooms;
      fact(on ? "on light%d" : "off light%d", light);
      fact("= (on-cost light%d) %d", light, between(1, 6));
      fact("= (off-cost light%d) 1", light);
      gains.add(between(1, 2));
      raises("light" + light, gains.get(light));
    }
    int shutters = share(8, 0);
    object("shutter", "shutter", shutters);
    for (int shutter = 0; shutter < shutters; shutter++) {
      fact("online shutter%d", shutter);
      fact("shutter-in shutter%d r%d", shutter, random.nextInt(rooms));
      fact(random.nextInt(3) == 0 ? "up shutter%d" : "down shutter%d", shutter);
      fact("= (shutter-cost shutter%d) %d", shutter, between(2, 4));
      raises("shutter" + shutter, between(1, 3));
    }
    for (int room = 0; room < rooms; room++) {
      levels.add(random.nextInt(3));
      fact("level r%d l%d", room, levels.get(room));
    }
  }

  private void raises(String agent, int by) {
    for (int level = 0; level + by < 6; level++) {
      fact("raises %s l%d l%d", agent, level, level + by);
    }
  }

  private void addEyes(int rooms) {
    int cameras = share(16, rooms);
    object("camera", "cam", cameras);
    for (int camera = 0; camera < cameras; camera++) {
      fact("online cam%d", camera);
      fact("covers cam%d r%d", camera, camera % rooms);
      fact("= (observe-cost cam%d) %d", camera, between(2, 7));
      for (int level = between(2, 3); level <= between(3, 4); level++) {
        fact("sees-at cam%d l%d", camera, level);
      }
    }
    int sensors = share(12, rooms);
    object("sensor", "lux", sensors);
    for (int sensor = 0; sensor < sensors; sensor++) {
      fact("online lux%d", sensor);
      fact("senses lux%d r%d", sensor, sensor % rooms);
      fact("= (measure-cost lux%d) %d", sensor, between(1, 3));
    }
  }

  private void addThings(int rooms) {
    items = share(8, 3);
    persons = share(4, 1);
    object("item", "item", items);
    object("person", "person", persons);
    for (int person = 0; person < persons; person++) {
      int room = random.nextInt(rooms);
      roomsOfPersons.add(room);
      fact("at person%d r%d", person, room);
    }
    for (int item = 0; item < items; item++) {
      fact("at item%d r%d", item, random.nextInt(rooms));
      fact("needs-grip item%d grip%d", item, random.nextInt(3));
      for (int person = 0; person < persons; person++) {
        fact("neighbour item%d person%d", item, person);
      }
    }
  }

  private void addRobots(int rooms) {
    int robots = share(4, 2);
    object("robot", "rob", robots);
    for (int robot = 0; robot < robots; robot++) {
      fact("online rob%d", robot);
      fact("hand-free rob%d", robot);
      fact("has-eye rob%d", robot);
      fact("robot-at rob%d r%d", robot, random.nextInt(rooms));
      fact("robot-kind rob%d kind%d", robot, random.nextInt(2));
      fact("grips rob%d grip%d", robot, random.nextInt(3));
      for (int grip = 0; grip < 3; grip++) {
        if (robot == 0 || random.nextBoolean()) {
          fact("grips rob%d grip%d", robot, grip);
        }
      }
      for (int level = 1; level < 5; level++) {
        fact("sees-at rob%d l%d", robot, level);
      }
      fact("= (pick-cost rob%d) %d", robot, between(3, 6));
      fact("= (place-cost rob%d) %d", robot, between(2, 5));
      fact("= (observe-cost rob%d) %d", robot, between(5, 12));
    }
  }
}
