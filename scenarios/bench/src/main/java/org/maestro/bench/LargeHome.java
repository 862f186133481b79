package org.maestro.bench;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;

/**
 * A home of many like rooms in rows of five, with open doors between neighbours: in each room a
 * camera, a light sensor, three lamps, a person and a robot that stands there, and things on the
 * floor. Every other room is dark.
 *
 * @param rooms from 1
 * @param robots one to a room, at most as many as rooms
 * @param thingsPerRoom from 0 to 5
 * @param robotsState whether robots state their prices as formulas and numbers; otherwise they have
 *     to be asked for each
 */
public record LargeHome(int rooms, int robots, int thingsPerRoom, boolean robotsState) {
  /** To a room. */
  public static final int LAMPS = 3;

  private static final int ROOMS_PER_ROW = 5;
  private static final double SIDE_METRES = 3;

  /** Prices of robots that state them: the way at full speed, and what arms take at least. */
  private static final String STATED_PRICES =
      """
      ;
       maestro:offers [ a :move ; maestro:cost "(+ 0.5 (/ (pathLength ?from ?to) (speed ?self)))" ] ,
         [ a :pick ; maestro:cost "6" ] , [ a :place ; maestro:cost "5" ]\
      """;

  /** One whose robots have to be asked for each price. */
  public LargeHome(int rooms, int robots, int thingsPerRoom) {
    this(rooms, robots, thingsPerRoom, false);
  }

  /** The same home with robots that state their prices. */
  public LargeHome withStatedPrices() {
    return new LargeHome(rooms, robots, thingsPerRoom, true);
  }

  /** Names of the zones are {@code z0}, {@code z1} ... */
  public String zone(int room) {
    return "z" + room;
  }

  public String person(int room) {
    return "Person" + room;
  }

  public String thing(int room, int number) {
    return "Thing" + room + "x" + number;
  }

  /**
   * @param number from 0 to 2
   */
  public String lamp(int room, int number) {
    return "lamp-%d-%d".formatted(room, number);
  }

  public Home home() {
    return new HomeLoader().load(turtle(), "large.ttl");
  }

  public Scene scene(Home home) {
    return SceneLoader.load(
        "large-scene.ttl",
        new ByteArrayInputStream(sceneTurtle().getBytes(StandardCharsets.UTF_8)),
        home);
  }

  private String turtle() {
    StringBuilder text =
        new StringBuilder(
            """
            @prefix : <https://w3id.org/maestro/domain#> .
            @prefix home: <https://w3id.org/maestro/home/large#> .
            @prefix maestro: <https://w3id.org/maestro#> .
            @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
            <https://w3id.org/maestro/home/large> a maestro:Home ; rdfs:label "a large home"@en .
            """);
    for (int room = 0; room < rooms; room++) {
      addRoom(text, room);
      if (hasNeighbourAtRight(room)) {
        double x = x(room) + SIDE_METRES;
        addDoor(text, room, room + 1, "%.1f %.1f", x, y(room) + 1, x, y(room) + 2);
      }
      if (room + ROOMS_PER_ROW < rooms) {
        double y = y(room) + SIDE_METRES;
        addDoor(text, room, room + ROOMS_PER_ROW, "%.1f %.1f", x(room) + 1, y, x(room) + 2, y);
      }
    }
    return text.toString();
  }

  private boolean hasNeighbourAtRight(int room) {
    return room % ROOMS_PER_ROW < ROOMS_PER_ROW - 1 && room + 1 < rooms;
  }

  private void addRoom(StringBuilder text, int room) {
    double x = x(room);
    double y = y(room);
    String outline =
        format(
            "%.1f %.1f, %.1f %.1f, %.1f %.1f, %.1f %.1f",
            x, y, x + SIDE_METRES, y, x + SIDE_METRES, y + SIDE_METRES, x, y + SIDE_METRES);
    int order = room * 10;
    text.append(
        format(
            """
            home:r%1$d a maestro:Room ; maestro:outline "%2$s" ; maestro:height 2.8 .
            home:z%1$d a maestro:Zone ; maestro:outline "%2$s" ; maestro:referencePoint "%3$.1f %4$.1f 0" .
            home:Person%1$d a :Person ; :colour "blue" ; :size "0.5 0.5 1.2" ; :usuallyIn home:z%1$d .
            home:cam-%1$d a :Camera ; maestro:order %5$d ; maestro:pose "%6$.1f %7$.1f 2.8" ;
              maestro:viewAngle 75 ; :minimumIlluminance 72 ; :maximumIlluminance 2000 .
            home:lux-%1$d a :LightSensor ; maestro:order %8$d ; maestro:pose "%3$.1f %4$.1f 0" .
            """,
            room, outline, x + 0.1, y + 0.1, order, x + 1.5, y + 1.5, order + 1));
    for (int lamp = 0; lamp < LAMPS; lamp++) {
      text.append(
          format(
              """
              home:lamp-%d-%d a :Lamp ; maestro:order %d ; maestro:pose "%.1f %.1f 2.8" ;
                maestro:luminousIntensity %d ; maestro:beamAngle 100 ; :power %d .
              """,
              room, lamp, order + 2 + lamp, x + 1.1 + 0.4 * lamp, y + 1.5, 900, 8 + 5 * lamp));
    }
    if (room < robots) {
      text.append(
          format(
              """
              home:robot-%d a :MobileRobot ; maestro:order %d ; :colour "orange" ;
                :size "0.58 0.38 0.4" ; :speed 0.8 ; :payload 0.5%s .
              """,
              room, order + 5, robotsState ? STATED_PRICES : ""));
    }
    for (int thing = 0; thing < thingsPerRoom; thing++) {
      text.append(
          format(
              """
              home:%s a :Item ; :colour "red" ; :size "0.08 0.08 0.1" ; :mass 0.25 ;
                :usuallyIn home:z%d .
              """,
              thing(room, thing), room));
    }
  }

  private static void addDoor(
      StringBuilder text,
      int from,
      int to,
      String point,
      double x1,
      double y1,
      double x2,
      double y2) {
    text.append(
        format(
            """
            home:door-%1$d-%2$d a maestro:Door ; maestro:openingFrom "%3$s" ;
              maestro:openingTo "%4$s" ; :side home:z%1$d , home:z%2$d ; :open true .
            """,
            from, to, format(point, x1, y1), format(point, x2, y2)));
  }

  private String sceneTurtle() {
    StringBuilder text =
        new StringBuilder(
            """
            @base <https://w3id.org/maestro/home/large> .
            @prefix scene: <https://w3id.org/maestro/scene#> .
            """);
    for (int room = 0; room < rooms; room++) {
      double x = x(room);
      double y = y(room);
      text.append(
          format(
              """
              <#z%1$d> scene:ambientLux %2$d .
              <#Person%1$d> scene:position "%3$.2f %4$.2f 0" ; scene:radius 0.25 .
              """,
              room, room % 2 == 0 ? 100 : 17, x + 0.6, y + 2.4));
      if (hasNeighbourAtRight(room)) {
        text.append(format("<#door-%d-%d> scene:open true .%n", room, room + 1));
      }
      if (room + ROOMS_PER_ROW < rooms) {
        text.append(format("<#door-%d-%d> scene:open true .%n", room, room + ROOMS_PER_ROW));
      }
      if (room < robots) {
        text.append(
            format("<#robot-%d> scene:position \"%.2f %.2f 0\" .%n", room, x + 1.5, y + 1.5));
      }
      for (int thing = 0; thing < thingsPerRoom; thing++) {
        text.append(
            format(
                "<#%s> scene:position \"%.2f %.2f 0\" ; scene:radius 0.04 ; scene:mass 0.25 .%n",
                thing(room, thing), x + 2.6, y + 0.5 + 0.4 * thing));
      }
    }
    return text.toString();
  }

  private static double x(int room) {
    return SIDE_METRES * (room % ROOMS_PER_ROW);
  }

  private static double y(int room) {
    int row = room / ROOMS_PER_ROW;
    return SIDE_METRES * row;
  }

  private static String format(String text, Object... values) {
    return String.format(Locale.ROOT, text, values);
  }
}
