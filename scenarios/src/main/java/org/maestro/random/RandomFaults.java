package org.maestro.random;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Draws what goes wrong while the goals are pursued: often nothing, seldom more than two things.
 */
final class RandomFaults {
  private static final int LATEST_MILLIS = 45_000;

  private final Chance chance;
  private final RandomHomes.Cast cast;
  private final FloorDraft floor;
  private final List<Fault> faults = new ArrayList<>();

  RandomFaults(Chance chance, RandomHomes.Cast cast, FloorDraft floor) {
    this.chance = chance;
    this.cast = cast;
    this.floor = floor;
  }

  List<Fault> draw() {
    int count = chance.oneOf(List.of(0, 1, 1, 1, 2, 2, 3));
    for (int i = 0; i < count; i++) {
      switch (chance.whole(0, 6)) {
        case 0, 1 -> death();
        case 2 -> loss();
        case 3 -> delay();
        case 4 -> weakness();
        case 5 -> moved();
        default -> taken();
      }
    }
    faults.sort(Comparator.comparing(Fault::at));
    return faults;
  }

  private void death() {
    String device = anyDevice();
    Duration at = time();
    faults.add(new Fault.Death(at, device));
    if (chance.happens(0.3)) {
      faults.add(new Fault.Revival(at.plus(time()), device));
    }
  }

  private void loss() {
    String member = anyDevice();
    Duration at = time();
    faults.add(new Fault.Cut(at, member));
    if (chance.happens(0.6)) {
      faults.add(new Fault.Return(at.plus(time()), member));
    }
  }

  private void delay() {
    Duration extra = Duration.ofMillis(chance.whole(100, 3000));
    faults.add(new Fault.Delay(time(), anyDevice(), extra, time()));
  }

  private void weakness() {
    if (!cast.lamps.isEmpty()) {
      faults.add(new Fault.Weakness(time(), chance.oneOf(cast.lamps), chance.number(0.1, 0.9)));
    }
  }

  private void moved() {
    String thing = chance.oneOf(cast.things());
    faults.add(new Fault.Moved(time(), thing, floor.free(floor.anyRoom(), 0.25, 0.45)));
  }

  private void taken() {
    String item = chance.oneOf(cast.items);
    if (chance.happens(0.5)) {
      faults.add(new Fault.Dropped(time(), item));
    } else {
      Duration at = time();
      faults.add(new Fault.Hidden(at, item, true));
      if (chance.happens(0.5)) {
        faults.add(new Fault.Hidden(at.plus(time()), item, false));
      }
    }
  }

  private String anyDevice() {
    return chance.oneOf(chance.happens(0.4) ? cast.robots : cast.devices);
  }

  private Duration time() {
    return Duration.ofMillis(chance.whole(0, LATEST_MILLIS));
  }
}
