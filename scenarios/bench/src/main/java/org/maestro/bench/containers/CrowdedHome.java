package org.maestro.bench.containers;

import java.util.Locale;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/**
 * A home of halls that are full of devices: of each ten four lamps, four light sensors, a camera
 * and a robot.
 *
 * @param devices in all, from 1
 * @param perHall so many at most are in one hall
 */
record CrowdedHome(int devices, int perHall) {
  private static final double SIDE_METRES = 20;
  private static final int COLUMNS = 20;
  private static final int ALIKE = 10;

  /** The first of them. */
  private static final int ROBOT = 9;

  Home home() {
    return new HomeLoader().load(turtle(), "crowded.ttl");
  }

  String turtle() {
    StringBuilder text =
        new StringBuilder(
            """
            @prefix : <https://w3id.org/maestro/domain#> .
            @prefix home: <https://w3id.org/maestro/home/crowded#> .
            @prefix maestro: <https://w3id.org/maestro#> .
            @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
            <https://w3id.org/maestro/home/crowded> a maestro:Home ; rdfs:label "a crowded home"@en .
            """);
    int halls = (devices + perHall - 1) / perHall;
    for (int hall = 0; hall < halls; hall++) {
      addHall(text, hall);
    }
    for (int device = 0; device < devices; device++) {
      addDevice(text, device);
    }
    return text.toString();
  }

  /** In which each robot has its place. */
  String scene() {
    StringBuilder text = new StringBuilder("@prefix scene: <https://w3id.org/maestro/scene#> .\n");
    for (int device = ROBOT; device < devices; device += ALIKE) {
      text.append(
          format(
              "<https://w3id.org/maestro/home/crowded#device-%d> scene:position \"%.2f %.2f 0\""
                  + " .\n",
              device, x(device), y(device)));
    }
    return text.toString();
  }

  private double x(int device) {
    int hall = device / perHall;
    return SIDE_METRES * hall + 0.5 + 0.95 * (device % perHall % COLUMNS);
  }

  private double y(int device) {
    return 0.5 + 0.95 * (device % perHall / COLUMNS % COLUMNS);
  }

  private static void addHall(StringBuilder text, int hall) {
    double x = SIDE_METRES * hall;
    String outline =
        format(
            "%.1f %.1f, %.1f %.1f, %.1f %.1f, %.1f %.1f",
            x, 0.0, x + SIDE_METRES, 0.0, x + SIDE_METRES, SIDE_METRES, x, SIDE_METRES);
    text.append(
        format(
            """
            home:hall-%1$d a maestro:Room ; maestro:outline "%2$s" ; maestro:height 2.8 .
            home:zone-%1$d a maestro:Zone ; maestro:outline "%2$s" ; maestro:referencePoint "%3$.1f 10.0 0" .
            """,
            hall, outline, x + SIDE_METRES / 2));
  }

  private void addDevice(StringBuilder text, int device) {
    String what =
        switch (device % ALIKE) {
          case 0, 2, 4, 6 ->
              "a :Lamp ; maestro:pose \"%.2f %.2f 2.8\" ; maestro:luminousIntensity 900 ;"
                  + " maestro:beamAngle 100 ; :power 8";
          case 1, 3, 5, 7 -> "a :LightSensor ; maestro:pose \"%.2f %.2f 0\"";
          case 8 ->
              "a :Camera ; maestro:pose \"%.2f %.2f 2.8\" ; maestro:viewAngle 75 ;"
                  + " :minimumIlluminance 72 ; :maximumIlluminance 2000";
          default ->
              "a :MobileRobot ; :colour \"orange\" ; :size \"0.58 0.38 0.4\" ; :speed 0.8 ;"
                  + " :payload 0.5";
        };
    text.append(format("home:device-%d maestro:order %d ; ", device, device));
    text.append(format(what, x(device), y(device))).append(" .\n");
  }

  private static String format(String text, Object... values) {
    return String.format(Locale.ROOT, text, values);
  }
}
