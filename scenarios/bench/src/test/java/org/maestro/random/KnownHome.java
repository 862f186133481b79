package org.maestro.random;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;

/**
 * A home in which it is plain what can be done: rooms in two rows with walls, open, driven, locked
 * or blocked doors between them, one or two robots, and a cup. Everything is seen and lit. Whether
 * the goal can be reached follows from a walk through the doors and from what hands can hold.
 */
final class KnownHome {
  private static final double ROOM = 3;
  private static final int COLUMNS = 3;

  /** What is between two rooms. */
  private enum Between {
    WALL,
    OPEN,
    DRIVEN,
    LOCKED,
    SHUT_BY_HAND;

    boolean canBePassed() {
      return this == OPEN || this == DRIVEN;
    }
  }

  /** What is asked of it. */
  enum Kind {
    /** To drive somewhere. */
    WAY,
    /** To bring a cup of any size and weight somewhere. */
    CUP
  }

  /**
   * One who drives and carries.
   *
   * @param fingers two of them; else a bag of grains
   */
  private record Robot(String name, int room, double payload, boolean fingers) {
    double opening() {
      return fingers ? 0.07 : 0.098;
    }
  }

  private final Random random;
  private final Kind kind;
  private final int rooms;
  private final List<int[]> ways = new ArrayList<>();
  private final List<Robot> robots = new ArrayList<>();
  private final StringBuilder home = new StringBuilder();
  private final StringBuilder scene = new StringBuilder();
  private final int cup;
  private final int target;
  private final double cupMass;
  private final double cupSize;
  private final int person;

  /** Else it is found out by trying. */
  private final boolean gripsAreStated;

  private int order;

  KnownHome(long seed, Kind kind) {
    this.random = new Random(seed * 31 + kind.ordinal());
    this.kind = kind;
    this.rooms = 2 + random.nextInt(5);
    this.cup = random.nextInt(rooms);
    this.target = random.nextInt(rooms);
    this.person = random.nextInt(rooms);
    this.cupMass = random.nextInt(4) == 0 ? 0.9 : 0.1 + 0.1 * random.nextInt(4);
    this.cupSize = List.of(0.05, 0.08, 0.08, 0.16).get(random.nextInt(4));
    this.gripsAreStated = random.nextBoolean();
    begin(seed);
    for (int room = 0; room < rooms; room++) {
      room(room);
    }
    for (int room = 0; room < rooms; room++) {
      if (room % COLUMNS + 1 < COLUMNS && room + 1 < rooms) {
        between(room, room + 1);
      }
      if (room + COLUMNS < rooms) {
        between(room, room + COLUMNS);
      }
    }
    robot("rose");
    if (random.nextBoolean()) {
      robot("tim");
    }
    things();
  }

  private void begin(long seed) {
    String iri = "https://w3id.org/maestro/home/known-" + seed;
    home.append(
        """
        @prefix : <https://w3id.org/maestro/domain#> .
        @prefix home: <%s#> .
        @prefix maestro: <https://w3id.org/maestro#> .
        @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
        <%s> a maestro:Home ; rdfs:label "Known home"@en .
        """
            .formatted(iri, iri));
    scene.append(
        """
        @base <%s> .
        @prefix scene: <https://w3id.org/maestro/scene#> .
        """
            .formatted(iri));
  }

  private static double x(int room) {
    return ROOM * (room % COLUMNS);
  }

  private static double y(int room) {
    return ROOM * (room / COLUMNS);
  }

  private void room(int room) {
    double x = x(room);
    double y = y(room);
    String outline =
        text("%.1f %.1f, %.1f %.1f, ", x, y, x + ROOM, y)
            + text("%.1f %.1f, %.1f %.1f", x + ROOM, y + ROOM, x, y + ROOM);
    home("room-%d a maestro:Room ; maestro:outline \"%s\" ; maestro:height 2.8", room, outline);
    home(
        "zone-%d a maestro:Zone ; maestro:outline \"%s\" ; maestro:referencePoint \"%s 0\"",
        room, outline, point(x + 0.1, y + 0.1));
    home(
        "cam-%d a :Camera ; maestro:order %d ; maestro:pose \"%s 2.8\" ; maestro:viewAngle 77 ;"
            + " :minimumIlluminance 72 ; :maximumIlluminance 2000",
        room, ++order, point(x + 1.5, y + 1.5));
    home(
        "lux-%d a :LightSensor ; maestro:order %d ; maestro:pose \"%s 0\"",
        room, ++order, point(x + 0.1, y + 0.1));
    scene("zone-%d> scene:ambientLux 200", room);
  }

  private void between(int first, int second) {
    Between kind = Between.values()[random.nextInt(Between.values().length)];
    if (kind == Between.WALL) {
      return;
    }
    boolean beside = second == first + 1;
    double x = x(second);
    double y = y(second);
    String from = beside ? point(x, y + 1) : point(x + 1, y);
    String to = beside ? point(x, y + 2) : point(x + 2, y);
    boolean hasDrive = kind == Between.DRIVEN || kind == Between.LOCKED;
    String name = "door-%d%d".formatted(first, second);
    home(
        "%s a %s ; maestro:openingFrom \"%s\" ; maestro:openingTo \"%s\" ;"
            + " :side home:zone-%d , home:zone-%d%s%s",
        name,
        hasDrive ? ":DrivenDoor ; maestro:order " + ++order : "maestro:Door",
        from,
        to,
        first,
        second,
        kind == Between.OPEN ? " ; :open true" : "",
        kind == Between.LOCKED ? " ; :locked true" : "");
    scene("%s> scene:open %s", name, kind == Between.OPEN);
    if (kind.canBePassed()) {
      ways.add(new int[] {first, second});
    }
  }

  private void robot(String name) {
    Robot robot =
        new Robot(name, random.nextInt(rooms), 0.2 + 0.1 * random.nextInt(5), random.nextBoolean());
    robots.add(robot);
    home(
        "%s a :MobileRobot ; maestro:order %d ;%s :colour \"%s\" ; :size \"0.58 0.38 0.4\" ;"
            + " :speed 0.8 ; :payload %s%s",
        name,
        ++order,
        robot.fingers() ? " maestro:driver \"mobile-robot-with-fingers\" ;" : "",
        name.equals("rose") ? "orange" : "pink",
        text("%.2f", robot.payload()),
        gripsAreStated ? text(" ; :gripperOpening %.3f", robot.opening()) : "");
    double place = name.equals("rose") ? 0.6 : 2.4;
    scene(
        "%s> scene:position \"%s 0\" ; scene:speed 0.8 ; scene:payload %s",
        name,
        point(x(robot.room()) + place, y(robot.room()) + place),
        text("%.2f", robot.payload()));
  }

  private void things() {
    String size = text("%.2f %.2f 0.1", cupSize, cupSize);
    home("Cup a :Item ; :colour \"red\" ; :size \"%s\" ; :mass %s", size, text("%.2f", cupMass));
    scene(
        "Cup> scene:position \"%s 0\" ; scene:radius %s ; scene:mass %s",
        point(x(cup) + 1.5, y(cup) + 1.5), text("%.2f", cupSize / 2), text("%.2f", cupMass));
    home("Bob a :Person ; :colour \"blue\" ; :size \"0.5 0.5 1.2\"");
    scene(
        "Bob> scene:position \"%s 0\" ; scene:radius 0.25",
        point(x(person) + 2.3, y(person) + 0.7));
  }

  String goal() {
    return kind == Kind.WAY
        ? "(in %s zone-%d)".formatted(robots.get(0).name(), target)
        : isForBob() ? "(nextTo Cup Bob)" : "(in Cup zone-%d)".formatted(target);
  }

  private boolean isForBob() {
    return target % 2 == 0;
  }

  /** Whether it can be done, or is so. */
  boolean isPossible() {
    if (kind == Kind.WAY) {
      return reached(robots.get(0).room()).contains(target);
    }
    int to = isForBob() ? person : target;
    return !isForBob() && to == cup
        || robots.stream()
            .filter(this::canHold)
            .anyMatch(robot -> reached(robot.room()).containsAll(List.of(cup, to)));
  }

  private boolean canHold(Robot robot) {
    return cupMass <= robot.payload() && cupSize <= robot.opening();
  }

  /** All rooms to which one comes from there. */
  private Set<Integer> reached(int from) {
    Set<Integer> reached = new TreeSet<>(Set.of(from));
    boolean grew = true;
    while (grew) {
      grew = false;
      for (int[] way : ways) {
        if (reached.contains(way[0]) != reached.contains(way[1])) {
          reached.add(way[0]);
          reached.add(way[1]);
          grew = true;
        }
      }
    }
    return reached;
  }

  String homeText() {
    return home.toString();
  }

  String sceneText() {
    return scene.toString();
  }

  private void home(String format, Object... values) {
    home.append("home:").append(format.formatted(values)).append(" .\n");
  }

  private void scene(String format, Object... values) {
    scene.append("<#").append(format.formatted(values)).append(" .\n");
  }

  private static String point(double x, double y) {
    return text("%.2f %.2f", x, y);
  }

  private static String text(String format, Object... values) {
    return String.format(Locale.ROOT, format, values);
  }
}
