package org.maestro.planning;

/**
 * Two rooms, two cameras, five lamps, two sensors and a robot, with round numbers: the home of the
 * design's worked example.
 */
public final class BobsHome {
  private BobsHome() {}

  public static SmallWorld words() {
    return new SmallWorld()
        .declare(
            "in", "observable functional", null, "(usuallyIn ?x ?p)", "?x - Thing", "?p - Place")
        .word("nextTo", "observable symmetric", "?a - Thing", "?b - Thing")
        .word("canSee", "observable", "?a - Device", "?x - Thing")
        .derived("handFree", "(not (exists (?x - Item) (in ?x ?r)))", "?r - Device")
        .derived(
            "passable",
            "(or (adjoins ?a ?b) (exists (?d - Door) (and (side ?d ?a) (side ?d ?b) (not (= ?a ?b))"
                + " (open ?d))))",
            "?a - Zone",
            "?b - Zone")
        .word("covers", "", "?d - Device", "?z - Zone")
        .word("senses", "", "?d - Device", "?z - Zone")
        .word("illuminance", "fluent observable", "?z - Zone")
        .word("gain", "fluent", "?l - Device", "?z - Zone")
        .word("level", "fluent", "?l - Device")
        .feature(
            "observeObject",
            "object:Thing ; zone:Zone",
            "(and (covers ?self ?zone) (or (in ?object ?zone) (unknown (in ?object ?zone)))"
                + " (>= (illuminance ?zone) (minimumIlluminance ?self))"
                + " (<= (illuminance ?zone) (maximumIlluminance ?self)))",
            "(and (sense (in ?object ?zone)) (canSee ?self ?object))")
        .feature(
            "measureIllumination",
            "; zone:Zone",
            "(senses ?self ?zone)",
            "(sense (illuminance ?zone))")
        .feature(
            "adjustLight",
            "level=0,0.5,1",
            "(not (= (level ?self) ?level))",
            "(and (assign (level ?self) ?level) (forall (?z - Zone) (when (> (gain ?self ?z) 0)"
                + " (increase (illuminance ?z) (* (gain ?self ?z) (- ?level (level ?self)))))))")
        .feature("openDoor", "", "(and (not (open ?self)) (not (locked ?self)))", "(open ?self)")
        .feature(
            "move",
            "to:Zone ; from:Zone",
            "(and (in ?self ?from) (passable ?from ?to))",
            "(in ?self ?to)")
        .feature(
            "pick",
            "object:Item ; zone:Zone",
            "(and (in ?self ?zone) (in ?object ?zone) (handFree ?self)"
                + " (<= (mass ?object) (payload ?self)))",
            "(and (in ?object ?self) (forall (?t - Thing) (not (nextTo ?object ?t)))"
                + " (forall (?a - Device) (not (canSee ?a ?object))))")
        .feature(
            "place",
            "object:Item target:Thing|Zone ; zone:Zone",
            "(and (in ?object ?self) (in ?self ?zone) (not (= ?target ?self))"
                + " (not (= ?target ?object)) (or (= ?target ?zone) (in ?target ?zone)))",
            "(and (in ?object ?zone) (when (Thing ?target) (nextTo ?object ?target)))");
  }

  public static SmallWorld dark() {
    SmallWorld world =
        words()
            .individuals("Zone Place", "zone-a", "zone-b")
            .individuals("Door", "door-ab")
            .individuals("Thing", "Bob")
            .individuals("Thing Item", "Cup")
            .facts("(side door-ab zone-a)", "(side door-ab zone-b)", "(open door-ab)")
            .facts("(= (mass Cup) 0.25)");
    camera(world, "cam-a", "zone-a");
    camera(world, "cam-b", "zone-b");
    sensor(world, "lux-a", "zone-a");
    sensor(world, "lux-b", "zone-b");
    lamp(world, "lamp-a1", 1, "1", "(= (gain lamp-a1 zone-a) 40)", "(= (gain lamp-a1 zone-b) 2)");
    lamp(world, "lamp-a2", 1, "1", "(= (gain lamp-a2 zone-a) 40)");
    lamp(world, "lamp-b1", 0, "1", "(= (gain lamp-b1 zone-b) 30)", "(= (gain lamp-b1 zone-a) 2)");
    lamp(world, "lamp-b2", 0, "2", "(= (gain lamp-b2 zone-b) 35)");
    lamp(world, "lamp-b3", 0, "3", "(= (gain lamp-b3 zone-b) 25)");
    robot(world, "rose", "zone-b", "5");
    return world;
  }

  static void camera(SmallWorld world, String name, String zone) {
    world
        .individuals("Thing Device", name)
        .facts(
            "(covers " + name + " " + zone + ")",
            "(in " + name + " " + zone + ")",
            "(= (minimumIlluminance " + name + ") 72)",
            "(= (maximumIlluminance " + name + ") 1000)")
        .offer(name, "observeObject", "2");
  }

  static void sensor(SmallWorld world, String name, String zone) {
    world
        .individuals("Thing Device", name)
        .facts("(senses " + name + " " + zone + ")", "(in " + name + " " + zone + ")")
        .offer(name, "measureIllumination", "1");
  }

  public static void lamp(
      SmallWorld world, String name, double level, String price, String... gains) {
    world
        .individuals("Thing Device", name)
        .facts("(= (level " + name + ") " + level + ")")
        .facts(gains)
        .offer(name, "adjustLight", price);
  }

  static void robot(SmallWorld world, String name, String zone, String movePrice) {
    world
        .individuals("Thing Device Place", name)
        .facts("(in " + name + " " + zone + ")", "(= (payload " + name + ") 0.5)")
        .offer(name, "move", movePrice)
        .offer(name, "pick", "4")
        .offer(name, "place", "3");
  }
}
