package org.maestro.sim.drivers;

import org.maestro.hal.IlluminationSensor;
import org.maestro.hal.Position;
import org.maestro.hal.Tsl2561;
import org.maestro.hal.Tsl2561.Range;
import org.maestro.sim.parameters.SensorData;
import org.maestro.sim.scene.WorldEvent;

/**
 * A TSL2561 that counts light: noise, whole counts, and a range that it changes when its counters
 * stand at their end or would do in a more sensitive one.
 */
final class SimulatedTsl2561 implements IlluminationSensor {

  private final Actuator actuator;
  private final SensorData data;
  private final Position place;
  private Range range = Range.USUAL;

  SimulatedTsl2561(Actuator actuator, SensorData data, Position place) {
    this.actuator = actuator;
    this.data = data;
    this.place = place;
  }

  @Override
  public void read(Listener listener) {
    actuator.command(
        WorldEvent.Kind.READ, range.seconds(), listener::failed, () -> count(listener));
  }

  private void count(Listener listener) {
    double lux =
        actuator.world().faults().shown(actuator.device(), actuator.world().lux(place))
            * (1 + actuator.error(data.noise()));
    Range fitting = fitting(lux);
    if (counts(lux, range) >= range.mostCounts() && fitting != range) {
      range = fitting;
      read(listener);
      return;
    }
    int visible = counts(lux, range);
    int infrared = (int) Math.round(visible * Tsl2561.INFRARED_SHARE);
    listener.measured(Tsl2561.lux(visible, infrared, range));
    range = fitting;
  }

  private static Range fitting(double lux) {
    for (Range candidate : Range.values()) {
      if (counts(lux, candidate) < candidate.mostCounts()) {
        return candidate;
      }
    }
    return Range.BRIGHT;
  }

  private static int counts(double lux, Range range) {
    double counts = lux * Tsl2561.COUNTS_PER_LUX * range.scale();
    return (int) Math.min(range.mostCounts(), Math.max(0, Math.round(counts)));
  }
}
