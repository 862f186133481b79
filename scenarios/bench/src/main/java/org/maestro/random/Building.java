package org.maestro.random;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/**
 * A building of many rooms on several floors, with about so many devices: in each room two lamps, a
 * camera and a light sensor, in every fourth a robot. Which rooms have doors between them, how
 * strong the lamps are, and where persons and things are follows from the seed; nobody knows it but
 * the scene. Floors lie beside each other, joined by one open door: the lift.
 */
public final class Building {
  private static final double SIDE_METRES = 4;
  private static final double DEVICES_PER_ROOM = 4.25;
  private static final int ROOMS_PER_ROBOT = 4;
  private static final int ROOMS_PER_PERSON = 4;
  private static final int ROOMS_PER_THING = 2;

  private final int floors;
  private final Chance chance;
  private final int side;
  private final int rooms;
  private final StringBuilder home =
      new StringBuilder(
          """
          @prefix : <https://w3id.org/maestro/domain#> .
          @prefix home: <https://w3id.org/maestro/home/building#> .
          @prefix maestro: <https://w3id.org/maestro#> .
          @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
          <https://w3id.org/maestro/home/building> a maestro:Home ; rdfs:label "a building"@en .
          """);
  private final StringBuilder scene =
      new StringBuilder(
          """
          @base <https://w3id.org/maestro/home/building> .
          @prefix scene: <https://w3id.org/maestro/scene#> .
          """);
  private final Map<String, Integer> robotRooms = new LinkedHashMap<>();
  private final Map<String, Integer> thingRooms = new LinkedHashMap<>();
  private int devices;

  /**
   * @param devices about so many
   * @param floors from 1
   * @param seed from which all else follows
   */
  public Building(int devices, int floors, long seed) {
    this.floors = floors;
    this.chance = new Chance(seed);
    int perFloor = (int) Math.max(1, Math.round(devices / DEVICES_PER_ROOM / floors));
    this.side = (int) Math.ceil(Math.sqrt(perFloor));
    this.rooms = perFloor * floors;
    for (int room = 0; room < rooms; room++) {
      addRoom(room);
    }
    doors().forEach(this::addDoor);
    for (int person = 0; person < persons(); person++) {
      addPerson(person);
    }
    for (int thing = 0; thing < things(); thing++) {
      addThing(thing);
    }
  }

  /** How many devices there are. */
  public int devices() {
    return devices;
  }

  /** Named {@code z0}, {@code z1} ... */
  public int rooms() {
    return rooms;
  }

  /** Named {@code Person0}, {@code Person1} ... */
  public int persons() {
    return Math.max(1, rooms / ROOMS_PER_PERSON);
  }

  /** Named {@code Thing0}, {@code Thing1} ... */
  public int things() {
    return Math.max(1, rooms / ROOMS_PER_THING);
  }

  /** In Turtle. */
  public String homeText() {
    return home.toString();
  }

  /** In Turtle: the truth. */
  public String sceneText() {
    return scene.toString();
  }

  /** The room's number in which each robot is at first. */
  public Map<String, Integer> robotRooms() {
    return Collections.unmodifiableMap(robotRooms);
  }

  /** The room's number in which each person and each thing is at first. */
  public Map<String, Integer> thingRooms() {
    return Collections.unmodifiableMap(thingRooms);
  }

  /** An opening between two rooms, in the wall between them. */
  private record Door(int first, int second) {}

  private int perFloor() {
    return rooms / floors;
  }

  private int column(int room) {
    return room % perFloor() % side + room / perFloor() * side;
  }

  private int row(int room) {
    return room % perFloor() / side;
  }

  private double x(int room) {
    return SIDE_METRES * column(room);
  }

  private double y(int room) {
    return SIDE_METRES * row(room);
  }

  /** From every room one gets into every other; some neighbours have no door between them. */
  private List<Door> doors() {
    List<Door> open = new ArrayList<>();
    for (int room = 0; room < rooms; room++) {
      int inFloor = room % perFloor();
      boolean hasLeft = inFloor % side > 0;
      boolean hasBelow = inFloor >= side;
      boolean left = hasLeft && (!hasBelow || chance.happens(0.75));
      if (left) {
        open.add(new Door(room - 1, room));
      }
      if (hasBelow && (!left || chance.happens(0.75))) {
        open.add(new Door(room - side, room));
      }
      if (inFloor == 0 && room > 0) {
        open.add(new Door(room - perFloor() + Math.min(side, perFloor()) - 1, room));
      }
    }
    return open;
  }

  private void addRoom(int room) {
    double x = x(room);
    double y = y(room);
    String outline =
        format(
            "%.1f %.1f, %.1f %.1f, %.1f %.1f, %.1f %.1f",
            x, y, x + SIDE_METRES, y, x + SIDE_METRES, y + SIDE_METRES, x, y + SIDE_METRES);
    add(
        home,
        """
        home:r%1$d a maestro:Room ; maestro:outline "%2$s" ; maestro:height 2.8 .
        home:z%1$d a maestro:Zone ; maestro:outline "%2$s" ; maestro:referencePoint "%3$.1f %4$.1f 0" .
        home:cam-%1$d a :Camera ; maestro:order %5$d ; maestro:pose "%6$.1f %7$.1f 2.8" ;
          maestro:viewAngle 100 ; :minimumIlluminance 72 ; :maximumIlluminance 2000 .
        home:lux-%1$d a :LightSensor ; maestro:order %5$d ; maestro:pose "%3$.1f %4$.1f 0" .
        """,
        room,
        outline,
        x + 0.1,
        y + 0.1,
        room,
        x + SIDE_METRES / 2,
        y + SIDE_METRES / 2);
    for (int lamp = 0; lamp < 2; lamp++) {
      add(
          home,
          """
          home:lamp-%1$d-%2$d a :Lamp ; maestro:order %1$d ; maestro:pose "%3$.1f %4$.1f 2.8" ;
            maestro:luminousIntensity %5$.0f ; maestro:beamAngle 120 ; :power %6$.0f .
          """,
          room,
          lamp,
          x + 1.6 + 0.8 * lamp,
          y + SIDE_METRES / 2,
          chance.number(1_400, 2_200),
          chance.number(8, 20));
    }
    devices += 4;
    add(scene, "<#z%d> scene:ambientLux %.0f .\n", room, chance.happens(0.5) ? 110.0 : 17.0);
    if (room % ROOMS_PER_ROBOT == 0) {
      devices++;
      robotRooms.put("robot-" + room, room);
      add(
          home,
          """
          home:robot-%1$d a :MobileRobot ; maestro:order %1$d ; :colour "orange" ;
            :size "0.58 0.38 0.4" ; :speed 0.8 ; :payload 0.5 .
          """,
          room);
      add(
          scene,
          "<#robot-%d> scene:position \"%.2f %.2f 0\" .\n",
          room,
          x + SIDE_METRES / 2,
          y + SIDE_METRES / 2);
    }
  }

  private void addDoor(Door door) {
    double x = x(door.second());
    double y = y(door.second());
    boolean beside = column(door.first()) < column(door.second());
    String name = format("door-%d-%d", door.first(), door.second());
    add(
        home,
        """
        home:%1$s a maestro:Door ; maestro:openingFrom "%2$.1f %3$.1f" ;
          maestro:openingTo "%4$.1f %5$.1f" ; :side home:z%6$d , home:z%7$d ; :open true .
        """,
        name,
        beside ? x : x + 1,
        beside ? y + 1 : y,
        beside ? x : x + 2,
        beside ? y + 2 : y,
        door.first(),
        door.second());
    add(scene, "<#%s> scene:open true .\n", name);
  }

  private void addPerson(int number) {
    int room = chance.whole(0, rooms - 1);
    thingRooms.put("Person" + number, room);
    add(home, "home:Person%d a :Person ; :colour \"blue\" ; :size \"0.5 0.5 1.2\" .\n", number);
    add(
        scene,
        "<#Person%d> scene:position \"%.2f %.2f 0\" ; scene:radius 0.25 .\n",
        number,
        x(room) + chance.number(0.5, 1.2),
        y(room) + chance.number(2.8, 3.5));
  }

  private void addThing(int number) {
    int room = chance.whole(0, rooms - 1);
    thingRooms.put("Thing" + number, room);
    add(
        home,
        "home:Thing%d a :Item ; :colour \"red\" ; :size \"0.08 0.08 0.1\" ; :mass 0.25 .\n",
        number);
    add(
        scene,
        "<#Thing%d> scene:position \"%.2f %.2f 0\" ; scene:radius 0.04 ; scene:mass 0.25 .\n",
        number,
        x(room) + chance.number(2.8, 3.6),
        y(room) + chance.number(0.5, 3.5));
  }

  private static void add(StringBuilder text, String format, Object... values) {
    text.append(format(format, values));
  }

  private static String format(String text, Object... values) {
    return String.format(Locale.ROOT, text, values);
  }
}
