package org.maestro.planning;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;

/**
 * Small homes by chance: zones at places on a plan, looks and ways of different costs, dark zones
 * with a lamp or without, cameras at the ceiling and on a robot, things that are usually somewhere.
 */
public final class SearchHomes {
  /** A home and who is sought in it. */
  public record SearchHome(
      SmallWorld world, List<String> zones, List<String> sought, String goal) {}

  private SearchHomes() {}

  public static SearchHome home(Random random, int zoneCount, int soughtCount) {
    List<String> zones = new ArrayList<>();
    SmallWorld world = words();
    for (int i = 1; i <= zoneCount; i++) {
      zones.add("zone-" + i);
    }
    world
        .individuals("Zone Place", zones.toArray(String[]::new))
        .individuals("Thing", "Bob")
        .individuals("Thing Item", "Cup")
        .facts("(= (mass Cup) 0.25)");
    Map<String, double[]> at = new TreeMap<>();
    zones.forEach(zone -> at.put(zone, new double[] {random.nextInt(12), random.nextInt(12)}));
    for (String from : zones) {
      world.facts("(= (floorArea " + from + ") " + (4 + random.nextInt(20)) + ")");
      for (String to : zones) {
        double distance =
            1 + Math.hypot(at.get(from)[0] - at.get(to)[0], at.get(from)[1] - at.get(to)[1]);
        world.facts("(adjoins " + from + " " + to + ")");
        world.facts("(= (way " + from + " " + to + ") " + Math.rint(10 * distance) / 10 + ")");
      }
    }
    robot(world, zones.get(random.nextInt(zoneCount)), random.nextInt(3) > 0);
    zones.forEach(zone -> equip(random, world, zone));
    boolean bobSought = soughtCount > 1;
    if (!bobSought) {
      world.facts("(in Bob " + zones.get(random.nextInt(zoneCount)) + ")");
    }
    for (String thing : List.of("Cup", "Bob")) {
      if (random.nextBoolean() && (thing.equals("Cup") || bobSought)) {
        world.facts("(usuallyIn " + thing + " " + zones.get(random.nextInt(zoneCount)) + ")");
      }
    }
    String goal =
        bobSought
            ? "(nextTo Cup Bob)"
            : List.of("(nextTo Cup Bob)", "(in Cup rose)", "(exists (?z - Zone) (in Cup ?z))")
                .get(random.nextInt(3));
    return new SearchHome(world, zones, bobSought ? List.of("Cup", "Bob") : List.of("Cup"), goal);
  }

  private static SmallWorld words() {
    return BobsHome.words()
        .word("floorArea", "fluent", "?z - Zone")
        .word("way", "fluent", "?a - Zone", "?b - Zone")
        .feature(
            "lookAround",
            "object:Thing ; zone:Zone",
            "(and (in ?self ?zone) (or (in ?object ?zone) (unknown (in ?object ?zone)))"
                + " (>= (illuminance ?zone) 72))",
            "(sense (in ?object ?zone))");
  }

  private static void robot(SmallWorld world, String zone, boolean sees) {
    BobsHome.robot(world, "rose", zone, "(way ?from ?to)");
    if (sees) {
      world.offer("rose", "lookAround", "3");
    }
  }

  private static void equip(Random random, SmallWorld world, String zone) {
    String suffix = zone.substring("zone".length());
    if (random.nextInt(4) > 0) {
      BobsHome.camera(world, "cam" + suffix, zone);
      world.withdraw("cam" + suffix);
      world.offer("cam" + suffix, "observeObject", String.valueOf(1 + random.nextInt(5)));
    }
    int light = random.nextInt(4);
    if (light > 0) {
      world.facts("(= (illuminance " + zone + ") " + (light == 1 ? 100 : 20) + ")");
    } else {
      BobsHome.sensor(world, "lux" + suffix, zone);
    }
    if (light != 1 && random.nextInt(5) > 0) {
      String lamp = "lamp" + suffix;
      String price = String.valueOf(1 + random.nextInt(8));
      BobsHome.lamp(world, lamp, 0, price, "(= (gain " + lamp + " " + zone + ") 60)");
    }
  }
}
