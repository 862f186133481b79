package org.maestro.sim.drivers;

import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.maestro.hal.Completion;
import org.maestro.hal.DimmableLamp;
import org.maestro.sim.parameters.LampData;
import org.maestro.sim.scene.WorldEvent;

/** A dimmable lamp with shades of white. */
final class SimulatedLamp implements DimmableLamp {

  private final Actuator actuator;
  private final LampData data;
  private int whiteKelvin;
  private OptionalDouble order = OptionalDouble.empty();

  SimulatedLamp(Actuator actuator, LampData data) {
    this.actuator = actuator;
    this.data = data;
    this.whiteKelvin = data.whiteKelvin();
  }

  @Override
  public void set(double level, OptionalInt white, Completion completion) {
    if (white.isPresent() && !whites().contains(white.getAsInt())) {
      completion.failed("it has no white of %d K".formatted(white.getAsInt()));
      return;
    }
    actuator.command(
        WorldEvent.Kind.ADJUST,
        data.transitionSeconds(),
        completion::failed,
        () -> {
          double before = actuator.world().lampLevel(actuator.device());
          actuator
              .world()
              .lighting()
              .setLevel(actuator.device(), actuator.flaw().reached(before, level));
          order = OptionalDouble.of(level);
          white.ifPresent(kelvin -> whiteKelvin = kelvin);
          actuator.tell(WorldEvent.Kind.LIT);
          completion.done();
        });
  }

  @Override
  public double level() {
    return actuator.flaw().repeatsOrders() && order.isPresent()
        ? order.getAsDouble()
        : actuator.world().lampLevel(actuator.device());
  }

  @Override
  public List<Integer> whites() {
    return data.whites();
  }

  @Override
  public int whiteKelvin() {
    return whiteKelvin;
  }
}
