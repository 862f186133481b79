package org.maestro.random;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;

/**
 * Draws homes: one to six rooms, desks, doors of all kinds, cameras, lamps and light sensors in
 * some of them, robots, persons and things. The home file tells what is known of them, the scene
 * what is true: where things are, which lamps are weak.
 */
public final class RandomHomes {
  private static final double CEILING = 2.8;
  private static final double CAMERA_LEAST_LUX = 72;
  private static final double CAMERA_GREATEST_LUX = 2000;
  private static final double ROBOT_RADIUS = 0.347;
  private static final double PERSON_RADIUS = 0.25;
  private static final double ITEM_RADIUS = 0.04;
  private static final List<String> PERSONS = List.of("Bob", "Ann");
  private static final List<String> ITEMS = List.of("Cup", "Book", "Key");
  private static final List<String> ROBOTS = List.of("rose", "tim", "eve");
  private static final List<String> COLOURS =
      List.of("blue", "pink", "red", "white", "yellow", "orange", "green", "grey");

  private final Chance chance;
  private final FloorDraft floor;
  private final StringBuilder home = new StringBuilder();
  private final StringBuilder scene = new StringBuilder();
  private final Cast cast = new Cast();
  private final List<Point2> deskPoints = new ArrayList<>();
  private int order;
  private int colour;
  private int fewestPersons;

  private RandomHomes(long seed) {
    this.chance = new Chance(seed);
    this.floor = new FloorDraft(chance);
    begin(seed);
  }

  /** The home of a seed: the same seed, the same home. */
  public static RandomHome of(long seed) {
    return new RandomHomes(seed).drawn(seed);
  }

  /** A home of a seed in which several goals are stated at once, so that much is under way. */
  public static RandomHome busy(long seed) {
    RandomHomes draft = new RandomHomes(seed);
    RandomHome home = draft.drawn(seed);
    List<String> goals = new ArrayList<>(home.goals());
    for (int more = 0; more < 2; more++) {
      goals.addAll(new RandomGoals(draft.chance, draft.cast, draft.floor).draw());
    }
    return new RandomHome(seed, home.homeText(), home.sceneText(), goals, home.faults());
  }

  /**
   * A home of a seed with a window and a shutter before it, under a sky that stays as it is; what
   * is asked there is light.
   */
  public static RandomHome withWindow(long seed) {
    RandomHomes draft = new RandomHomes(seed);
    draft.window();
    RandomHome home = draft.drawn(seed);
    return new RandomHome(
        seed,
        home.homeText(),
        home.sceneText(),
        new RandomGoals(draft.chance, draft.cast, draft.floor).drawLight(),
        home.faults());
  }

  /** The home of a seed in which devices are broken, or say what is not so. */
  public static RandomHome withLiars(long seed) {
    RandomHomes draft = new RandomHomes(seed);
    RandomHome home = draft.drawn(seed);
    List<Fault> faults = new ArrayList<>(home.faults());
    List<Fault.Flawed> flaws = new RandomFaults(draft.chance, draft.cast, draft.floor).drawFlaws();
    faults.addAll(flaws);
    List<String> goals =
        new RandomGoals(draft.chance, draft.cast, draft.floor)
            .drawOf(flaws.stream().map(Fault.Flawed::device).toList());
    return new RandomHome(
        seed, home.homeText(), home.sceneText(), goals.isEmpty() ? home.goals() : goals, faults);
  }

  /**
   * The home of a seed in which the main process stands still for a while, mostly beside devices
   * that lie: also bases that do not drive, and cameras.
   */
  public static RandomHome harsh(long seed) {
    RandomHomes draft = new RandomHomes(seed);
    RandomHome home = draft.drawn(seed);
    RandomFaults more = new RandomFaults(draft.chance, draft.cast, draft.floor);
    List<Fault.Flawed> flaws = draft.chance.happens(0.75) ? more.drawWorseFlaws() : List.of();
    List<Fault> faults = new ArrayList<>(draft.chance.happens(0.5) ? home.faults() : List.of());
    faults.addAll(flaws);
    if (flaws.isEmpty() || draft.chance.happens(0.6)) {
      faults.addAll(more.drawFreezes());
    }
    List<String> goals =
        new RandomGoals(draft.chance, draft.cast, draft.floor)
            .drawOfAny(flaws.stream().map(Fault.Flawed::device).toList());
    return new RandomHome(
        seed, home.homeText(), home.sceneText(), goals.isEmpty() ? home.goals() : goals, faults);
  }

  /**
   * The home of a seed in which one or two persons go about of their own accord, stand in doors,
   * take things and put them down elsewhere.
   */
  public static RandomHome inhabited(long seed) {
    RandomHomes draft = new RandomHomes(seed);
    draft.fewestPersons = 1;
    RandomHome home = draft.drawn(seed);
    for (String person : draft.cast.persons) {
      draft.scene("%s> scene:roams %s".formatted(person, number(draft.chance.number(1, 12))));
    }
    return new RandomHome(
        seed, home.homeText(), draft.scene.toString(), home.goals(), home.faults());
  }

  /** The same, in which cameras find things in the pictures that they take. */
  public static RandomHome seenInPictures(long seed) {
    return inhabited(seed).in(Map.of("world.camera.fromPixels", "true"));
  }

  private RandomHome drawn(long seed) {
    map();
    devices();
    bodies();
    return new RandomHome(
        seed,
        home.toString(),
        scene.toString(),
        new RandomGoals(chance, cast, floor).draw(),
        new RandomFaults(chance, cast, floor).draw());
  }

  /** In the lower wall of the first room. */
  private void window() {
    FloorDraft.Room room = floor.rooms().get(0);
    double x = round(room.x() + chance.number(0.3, 1.2));
    home(
        "window a maestro:Window ; maestro:glassFrom \"%s 0 0.9\" ; maestro:glassTo \"%s 0 %s\""
            .formatted(
                number(x),
                number(round(x + chance.number(0.6, 1.4))),
                number(chance.number(1.6, 2.4))));
    device(cast.shutters, "shutter", ":Shutter", "maestro:shades home:window");
    scene("shutter> scene:opening %s".formatted(chance.oneOf(List.of("0", "0.5", "1"))));
    scene.append(
        "<> scene:latitude 49 ; scene:dayOfYear %d ; scene:solarTime \"%02d:00\" ; scene:north 90 ; scene:cloudCover 1 ; scene:cloudChange 0 ; scene:cloudMinutes 60 .\n"
            .formatted(chance.whole(60, 300), chance.whole(6, 18)));
  }

  private void begin(long seed) {
    String iri = "https://w3id.org/maestro/home/random-" + seed;
    home.append(
        """
        @prefix : <https://w3id.org/maestro/domain#> .
        @prefix home: <%s#> .
        @prefix maestro: <https://w3id.org/maestro#> .
        @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
        <%s> a maestro:Home ; rdfs:label "Random home %d"@en .
        """
            .formatted(iri, iri, seed));
    scene.append(
        """
        @base <%s> .
        @prefix scene: <https://w3id.org/maestro/scene#> .
        """
            .formatted(iri));
  }

  private void map() {
    for (FloorDraft.Room room : floor.rooms()) {
      String outline = outline(room);
      home(
          "room-%s a maestro:Room ; maestro:outline \"%s\" ; maestro:height 2.8"
              .formatted(room.letter(), outline));
      home(
          "%s a maestro:Zone ; maestro:outline \"%s\" ; maestro:referencePoint \"%s 0\""
              .formatted(room.zone(), outline, text(reference(room))));
      scene(
          "%s> scene:ambientLux %s"
              .formatted(
                  room.zone(),
                  number(chance.happens(0.3) ? chance.number(80, 400) : chance.number(0, 60))));
      cast.zones.add(room.zone());
      if (chance.happens(0.2)) {
        desk(room);
      }
    }
    for (FloorDraft.Door door : floor.doors()) {
      home(
          ("%s a %s ; maestro:openingFrom \"%s\" ; maestro:openingTo \"%s\" ; :side home:%s ,"
                  + " home:%s%s%s")
              .formatted(
                  door.name(),
                  door.kind().isDriven()
                      ? ":DrivenDoor ; maestro:order " + ++order
                      : "maestro:Door",
                  text(door.from()),
                  text(door.to()),
                  door.first().zone(),
                  door.second().zone(),
                  door.kind().isOpen() && !door.kind().isDriven() ? " ; :open true" : "",
                  door.kind() == FloorDraft.Kind.DRIVEN_LOCKED ? " ; :locked true" : ""));
      scene("%s> scene:open %s".formatted(door.name(), door.kind().isOpen()));
      cast.doors.add(door.name());
      if (door.kind().isDriven()) {
        cast.devices.add(door.name());
      }
    }
  }

  /** In the far corner: what stands on the floor may stand under it. */
  private void desk(FloorDraft.Room room) {
    double x = round(room.x() + room.width() - 0.6);
    double y = round(room.y() + room.depth() - 0.5);
    home(
        ("desk-%s a maestro:Location ; maestro:outline \"%s %s, %s %s, %s %s, %s %s\" ;"
                + " maestro:referencePoint \"%s 0.75\"")
            .formatted(
                room.letter(),
                number(x - 0.4),
                number(y - 0.3),
                number(x + 0.4),
                number(y - 0.3),
                number(x + 0.4),
                number(y + 0.3),
                number(x - 0.4),
                number(y + 0.3),
                text(new Point2(x, y))));
    cast.desks.add("desk-" + room.letter());
    deskPoints.add(new Point2(x, y));
  }

  private void devices() {
    for (int i = 0; i < cast.desks.size(); i++) {
      device(
          cast.sensors,
          "lux-" + cast.desks.get(i),
          ":LightSensor",
          "maestro:pose \"%s 0.75\"".formatted(text(deskPoints.get(i))));
    }
    for (FloorDraft.Room room : floor.rooms()) {
      if (chance.happens(0.9)) {
        device(cast.cameras, "cam-" + room.letter(), ":Camera", camera(room));
      }
      int lamps = chance.oneOf(List.of(0, 1, 2, 2, 3));
      for (int i = 1; i <= lamps; i++) {
        lamp(room, "lamp-" + room.letter() + i);
      }
      if (chance.happens(0.94)) {
        device(
            cast.sensors,
            "lux-" + room.letter(),
            ":LightSensor",
            "maestro:pose \"%s 0\"".formatted(text(reference(room))));
      }
    }
  }

  /** Most see their whole room; some only a part of it, and cover nothing. */
  private String camera(FloorDraft.Room room) {
    double halfDiagonal = Math.hypot(room.width(), room.depth()) / 2;
    double angle = 2 * Math.toDegrees(Math.atan(halfDiagonal / CEILING)) + 2;
    return "maestro:pose \"%s %s\" ; maestro:viewAngle %s ; :minimumIlluminance %s ; :maximumIlluminance %s"
        .formatted(
            text(room.middle()),
            number(CEILING),
            number(Math.ceil(chance.happens(0.06) ? angle / 2 : angle)),
            number(CAMERA_LEAST_LUX),
            number(CAMERA_GREATEST_LUX));
  }

  private void lamp(FloorDraft.Room room, String name) {
    Point2 middle = room.middle();
    String place =
        text(
            new Point2(
                round(middle.x() + chance.number(-0.5, 0.5)),
                round(middle.y() + chance.number(-0.5, 0.5))));
    device(
        cast.lamps,
        name,
        ":Lamp",
        "maestro:pose \"%s %s\" ; maestro:luminousIntensity %d ; maestro:beamAngle %d ; :power %d"
            .formatted(
                place,
                number(CEILING),
                chance.whole(400, 2200),
                chance.oneOf(List.of(110, 120)),
                chance.whole(4, 30)));
    if (chance.happens(0.3)) {
      scene("%s> scene:level 1.0".formatted(name));
    }
    if (chance.happens(0.25)) {
      scene("%s> scene:strength %s".formatted(name, number(chance.number(0.3, 0.95))));
    }
  }

  private void bodies() {
    int robots = chance.oneOf(List.of(1, 1, 1, 2, 2, 3));
    for (String name : ROBOTS.subList(0, robots)) {
      String speed = number(chance.number(0.4, 1.2));
      String payload = number(chance.number(0.3, 0.9));
      device(
          cast.robots,
          name,
          ":MobileRobot",
          ":colour \"%s\" ; :size \"0.58 0.38 0.4\" ; :speed %s ; :payload %s"
              .formatted(nextColour(), speed, payload));
      scene(
          "%s> scene:position \"%s\" ; scene:speed %s ; scene:payload %s"
              .formatted(
                  name, text(floor.place(floor.anyRoom(), ROBOT_RADIUS, 0.5)), speed, payload));
    }
    for (String name : PERSONS.subList(0, chance.whole(fewestPersons, 2))) {
      body(cast.persons, name, ":Person", "0.5 0.5 1.2", PERSON_RADIUS, "");
    }
    for (String name : ITEMS.subList(0, chance.whole(1, 3))) {
      String mass =
          number(chance.happens(0.9) ? chance.number(0.05, 0.4) : chance.number(0.4, 0.9));
      body(cast.items, name, ":Item", "0.08 0.08 0.1", ITEM_RADIUS, mass);
    }
  }

  private void body(
      List<String> list, String name, String type, String size, double radius, String mass) {
    FloorDraft.Room room = floor.anyRoom();
    String usual =
        chance.happens(0.6)
            ? " ; :usuallyIn home:" + (chance.happens(0.7) ? room : floor.anyRoom()).zone()
            : "";
    home(
        "%s a %s ; :colour \"%s\" ; :size \"%s\"%s%s"
            .formatted(
                name, type, nextColour(), size, mass.isEmpty() ? "" : " ; :mass " + mass, usual));
    scene(
        "%s> scene:position \"%s\" ; scene:radius %s%s%s"
            .formatted(
                name,
                text(floor.place(room, radius, radius + 0.2)),
                number(radius),
                mass.isEmpty() ? "" : " ; scene:mass " + mass,
                !mass.isEmpty() && chance.happens(0.06) ? " ; scene:hidden true" : ""));
    list.add(name);
  }

  private void device(List<String> list, String name, String type, String rest) {
    home("%s a %s ; maestro:order %d ; %s".formatted(name, type, ++order, rest));
    list.add(name);
    cast.devices.add(name);
  }

  private String nextColour() {
    return COLOURS.get(colour++);
  }

  private void home(String statement) {
    home.append("home:").append(statement).append(" .\n");
  }

  private void scene(String statement) {
    scene.append("<#").append(statement).append(" .\n");
  }

  private static Point2 reference(FloorDraft.Room room) {
    return new Point2(round(room.x() + 0.1), round(room.y() + 0.1));
  }

  private static String outline(FloorDraft.Room room) {
    double right = round(room.x() + room.width());
    double top = round(room.y() + room.depth());
    return "%s %s, %s %s, %s %s, %s %s"
        .formatted(
            number(room.x()),
            number(room.y()),
            number(right),
            number(room.y()),
            number(right),
            number(top),
            number(room.x()),
            number(top));
  }

  private static double round(double number) {
    return Math.round(100 * number) / 100.0;
  }

  private static String number(double number) {
    return String.format(Locale.ROOT, "%.2f", number);
  }

  private static String text(Point2 point) {
    return number(point.x()) + " " + number(point.y());
  }

  private static String text(Position place) {
    return text(place.floor()) + " 0";
  }

  /** The names of all persons, things, places and devices of a home. */
  static final class Cast {
    final List<String> zones = new ArrayList<>();
    final List<String> desks = new ArrayList<>();
    final List<String> doors = new ArrayList<>();
    final List<String> cameras = new ArrayList<>();
    final List<String> lamps = new ArrayList<>();
    final List<String> shutters = new ArrayList<>();
    final List<String> sensors = new ArrayList<>();
    final List<String> robots = new ArrayList<>();
    final List<String> persons = new ArrayList<>();
    final List<String> items = new ArrayList<>();
    final List<String> devices = new ArrayList<>();

    List<String> things() {
      List<String> things = new ArrayList<>(persons);
      things.addAll(items);
      return things;
    }
  }
}
