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

  private String goal() {
    if (chance.happens(0.15)) {
      return "(and " + plain() + " " + plain() + ")";
    }
    return plain();
  }

  private String plain() {
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
    String zone = chance.oneOf(cast.zones);
    return chance.happens(0.8)
        ? "(>= (illuminance " + zone + ") " + chance.whole(4, 30) * 10 + ")"
        : "(<= (illuminance " + zone + ") " + chance.whole(4, 30) * 10 + ")";
  }
}
