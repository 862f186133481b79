package org.maestro.random;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;

/** Draws what is asked in a home. */
final class RandomGoals {
  private final Chance chance;
  private final RandomHomes.Cast cast;
  private final FloorDraft floor;

  RandomGoals(Chance chance, RandomHomes.Cast cast, FloorDraft floor) {
    this.chance = chance;
    this.cast = cast;
    this.floor = floor;
  }

  List<String> draw() {
    List<String> goals = new ArrayList<>();
    goals.add(goal());
    if (chance.happens(0.25)) {
      goals.add(goal());
    }
    return goals;
  }

  /** What one of these devices has to do with. */
  List<String> drawOf(List<String> devices) {
    List<String> goals = new ArrayList<>();
    devices.stream().distinct().forEach(device -> goals.add(goalOf(device)));
    return goals;
  }

  /** The same, also of driving and looking. */
  List<String> drawOfAny(List<String> devices) {
    return devices.stream().distinct().map(this::goalOfAny).toList();
  }

  private String goalOfAny(String device) {
    if (cast.robots.contains(device) && chance.happens(0.3)) {
      return "(in " + device + " " + chance.oneOf(cast.zones) + ")";
    }
    if (cast.cameras.contains(device)) {
      return chance.happens(0.3)
          ? "(canSee " + device + " " + chance.oneOf(cast.things()) + ")"
          : chance.happens(0.5) ? nextTo() : itemIn();
    }
    return goalOf(device);
  }

  private String goalOf(String device) {
    if (cast.robots.contains(device)) {
      return chance.happens(0.3)
          ? "(in " + chance.oneOf(cast.items) + " " + device + ")"
          : chance.happens(0.5) ? nextTo() : itemIn();
    }
    if (cast.doors.contains(device)) {
      return "(open " + device + ")";
    }
    if (cast.lamps.contains(device) && chance.happens(0.3)) {
      return "(%s (level %s) 0.5)".formatted(chance.happens(0.7) ? ">=" : "<=", device);
    }
    return "(>= (illuminance %s) %d)".formatted(placeOf(device), lux());
  }

  /** Lamps and sensors are named after the place in which they are. */
  private String placeOf(String device) {
    String place = device.replaceFirst("^lamp-(.).*$", "zone-$1").replaceFirst("^lux-", "");
    return place.length() == 1 ? "zone-" + place : place;
  }

  /** What is asked where the sun shines in. */
  List<String> drawLight() {
    List<String> goals = new ArrayList<>();
    goals.add(
        chance.happens(0.25)
            ? "(keep " + brightness() + ")"
            : chance.happens(0.3)
                ? "(and " + brightness() + " " + brightness() + ")"
                : brightness());
    if (chance.happens(0.25)) {
      goals.add(plain());
    }
    return goals;
  }

  private String goal() {
    if (chance.happens(0.08)) {
      return "(keep " + brightness() + ")";
    }
    if (chance.happens(0.15)) {
      return "(and " + plain() + " " + plain() + ")";
    }
    if (chance.happens(0.05)) {
      return "(or " + plain() + " " + plain() + ")";
    }
    return plain();
  }

  private String plain() {
    return chance.happens(0.3) ? unusual() : usual();
  }

  private String usual() {
    List<Supplier<String>> kinds = new ArrayList<>();
    kinds.add(this::nextTo);
    kinds.add(this::nextTo);
    kinds.add(this::itemIn);
    kinds.add(() -> "(in " + chance.oneOf(cast.robots) + " " + chance.oneOf(cast.zones) + ")");
    kinds.add(() -> "(in " + chance.oneOf(cast.items) + " " + chance.oneOf(cast.robots) + ")");
    kinds.add(this::brightness);
    kinds.add(() -> "(canSee ?agent " + chance.oneOf(cast.things()) + ")");
    if (!cast.cameras.isEmpty()) {
      kinds.add(
          () -> "(canSee " + chance.oneOf(cast.cameras) + " " + chance.oneOf(cast.things()) + ")");
    }
    if (!cast.doors.isEmpty()) {
      kinds.add(() -> "(open " + chance.oneOf(cast.doors) + ")");
    }
    return chance.oneOf(kinds).get();
  }

  /** Goals over classes, superclasses, all of a kind, what is not to be, and devices' numbers. */
  private String unusual() {
    List<Supplier<String>> kinds = new ArrayList<>();
    kinds.add(() -> "(exists (?x - Item) (in ?x " + chance.oneOf(cast.zones) + "))");
    kinds.add(() -> "(exists (?x - Item) (nextTo ?x " + chance.oneOf(cast.things()) + "))");
    kinds.add(() -> "(exists (?r - MobileRobot) (in ?r " + chance.oneOf(cast.zones) + "))");
    kinds.add(() -> "(exists (?d - Device) (canSee ?d " + chance.oneOf(cast.things()) + "))");
    kinds.add(() -> "(exists (?t - Thing) (nextTo " + chance.oneOf(cast.items) + " ?t))");
    kinds.add(() -> "(exists (?z - Location) (>= (illuminance ?z) " + lux() + "))");
    kinds.add(() -> "(forall (?x - Item) (in ?x " + chance.oneOf(cast.zones) + "))");
    kinds.add(() -> "(forall (?z - Zone) (>= (illuminance ?z) " + lux() + "))");
    kinds.add(() -> "(in ?x " + chance.oneOf(cast.robots) + ")");
    kinds.add(() -> "(not (in " + chance.oneOf(cast.items) + " " + chance.oneOf(cast.zones) + "))");
    kinds.add(
        () -> "(not (in " + chance.oneOf(cast.robots) + " " + chance.oneOf(cast.zones) + "))");
    kinds.add(() -> "(not " + nextTo() + ")");
    if (!cast.lamps.isEmpty()) {
      kinds.add(
          () ->
              "(%s (level %s) 0.5)"
                  .formatted(chance.happens(0.5) ? ">=" : "<=", chance.oneOf(cast.lamps)));
    }
    if (!cast.desks.isEmpty()) {
      kinds.add(() -> "(>= (illuminance " + chance.oneOf(cast.desks) + ") " + lux() + ")");
    }
    return chance.oneOf(kinds).get();
  }

  private String nextTo() {
    String item = chance.oneOf(cast.items);
    List<String> others = new ArrayList<>(cast.things());
    others.remove(item);
    return others.isEmpty() ? itemIn() : "(nextTo " + item + " " + chance.oneOf(others) + ")";
  }

  private String itemIn() {
    return "(in " + chance.oneOf(cast.items) + " " + floor.anyRoom().zone() + ")";
  }

  private String brightness() {
    List<String> locations = new ArrayList<>(cast.zones);
    locations.addAll(cast.desks);
    String relation = chance.happens(0.8) ? ">=" : "<=";
    return "(%s (illuminance %s) %d)".formatted(relation, chance.oneOf(locations), lux());
  }

  private int lux() {
    return chance.whole(4, 30) * 10;
  }
}
