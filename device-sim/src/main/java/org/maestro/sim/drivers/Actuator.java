package org.maestro.sim.drivers;

import java.time.Duration;
import java.util.Optional;
import java.util.Random;
import java.util.function.Consumer;
import org.maestro.rats.time.Clock;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Flaw;
import org.maestro.sim.world.World;

/**
 * The common part of a device's simulated drivers: time, chance, power and defects. Clock thread
 * only.
 */
public final class Actuator {

  private static final double NANOS = 1e9;

  private final String device;
  private final World world;
  private final Clock clock;
  private final Random random;

  public Actuator(String device, World world, Clock clock, Random random) {
    this.device = device;
    this.world = world;
    this.clock = clock;
    this.random = random;
  }

  String device() {
    return device;
  }

  Flaw flaw() {
    return world.faults().flaw(device);
  }

  World world() {
    return world;
  }

  Clock clock() {
    return clock;
  }

  /** From a normal distribution around 0. */
  double error(double standardDeviation) {
    return standardDeviation * random.nextGaussian();
  }

  boolean happens(double probability) {
    return random.nextDouble() < probability;
  }

  /** Of any value alike. */
  long number() {
    return random.nextLong();
  }

  /**
   * A command: told to the world, then its effect after the time it takes, unless the device dies
   * or is defect.
   */
  void command(WorldEvent.Kind kind, double seconds, Consumer<String> failed, Runnable effect) {
    world.tell(kind, device, Optional.empty());
    after(
        seconds,
        () -> {
          Optional<String> defect = world.faults().defect(device);
          if (defect.isPresent()) {
            failed.accept(defect.get());
          } else {
            effect.run();
          }
        });
  }

  /** Runs it later, if the device has power then. */
  void after(double seconds, Runnable effect) {
    if (world.isAlive(device)) {
      clock.schedule(
          Duration.ofNanos(Math.round(seconds * NANOS)), device, () -> whenThawed(effect));
    }
  }

  private void whenThawed(Runnable effect) {
    Duration frozen = world.faults().frozenFor(device);
    if (!frozen.isZero()) {
      clock.schedule(frozen, device, () -> whenThawed(effect));
    } else if (world.isAlive(device)) {
      effect.run();
    }
  }

  /** Runs it later, whether the device has power then or not, unless the world has ended. */
  void afterInAnyCase(double seconds, Runnable effect) {
    world.later(device, seconds, effect);
  }

  void tell(WorldEvent.Kind kind) {
    world.tell(kind, device, Optional.empty());
  }
}
