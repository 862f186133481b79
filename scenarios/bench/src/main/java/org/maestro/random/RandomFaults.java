package org.maestro.random;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.maestro.sim.world.Flaw;

/**
 * Draws what goes wrong while the goals are pursued: often nothing, seldom more than two things.
 */
final class RandomFaults {
  private static final int LATEST_MILLIS = 45_000;

  /** Most goals are over after some seconds. */
  private static final int LATEST_FREEZE_MILLIS = 8_000;

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

  /** Draws who does not do what it says, mostly from the beginning on: one device, or two. */
  List<Fault.Flawed> drawFlaws() {
    List<Fault.Flawed> flaws = new ArrayList<>();
    int count = chance.whole(1, 2);
    for (int i = 0; i < count; i++) {
      switch (chance.whole(0, 5)) {
        case 0, 1 -> flaw(flaws, cast.lamps, List.of(Flaw.IDLE, Flaw.BOASTING, Flaw.HALF));
        case 2, 3 -> flaw(flaws, cast.robots, List.of(Flaw.IDLE, Flaw.BOASTING));
        case 4 -> flaw(flaws, drivenDoors(), List.of(Flaw.IDLE, Flaw.BOASTING));
        default -> flaw(flaws, cast.sensors, List.of(Flaw.STUCK));
      }
    }
    return flaws;
  }

  /** Draws one more who lies: a base, a camera, or any of the others. */
  List<Fault.Flawed> drawWorseFlaws() {
    List<Fault.Flawed> flaws = new ArrayList<>();
    switch (chance.whole(0, 4)) {
      case 0, 1 -> flaw(flaws, cast.robots, List.of(Flaw.STANDING, Flaw.SPINNING));
      case 2, 3 -> flaw(flaws, cast.cameras, List.of(Flaw.BLIND, Flaw.SEEING_THINGS));
      default -> flaws.addAll(drawFlaws());
    }
    return flaws;
  }

  /** Draws when the main process stands still: once, or twice one after the other. */
  List<Fault> drawFreezes() {
    List<Fault> freezes = new ArrayList<>();
    Duration at = Duration.ofMillis(chance.whole(0, LATEST_FREEZE_MILLIS));
    for (int left = chance.oneOf(List.of(1, 1, 2)); left > 0; left--) {
      Duration lasts = Duration.ofMillis(chance.whole(1_000, 30_000));
      freezes.add(new Fault.Frozen(at, lasts));
      at = at.plus(lasts).plusMillis(chance.whole(0, LATEST_FREEZE_MILLIS));
    }
    return freezes;
  }

  private void flaw(List<Fault.Flawed> flaws, List<String> devices, List<Flaw> kinds) {
    if (!devices.isEmpty()) {
      Duration at = chance.happens(0.8) ? Duration.ZERO : Duration.ofMillis(chance.whole(0, 8_000));
      flaws.add(new Fault.Flawed(at, chance.oneOf(devices), chance.oneOf(kinds)));
    }
  }

  private List<String> drivenDoors() {
    return cast.doors.stream().filter(cast.devices::contains).toList();
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
