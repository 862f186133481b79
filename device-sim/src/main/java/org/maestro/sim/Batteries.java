package org.maestro.sim;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * What is left in robots' batteries: each moment is reckoned from what was drawn since the last
 * charge, so that nothing has to happen meanwhile. Guarded by the world's lock.
 */
final class Batteries {

  private static final double JOULES_PER_WATT_HOUR = 3600;
  private static final double NANOS = 1e9;

  private final Map<String, Battery> batteries = new TreeMap<>();

  /**
   * @param charge share that was in it then
   * @param since the moment of that
   * @param driven for how long the robot had driven until then
   * @param extraJoules drawn since by what is neither idle nor driving
   */
  private record Battery(
      PhysicalParameters.BatteryData data,
      double drivingWatts,
      double charge,
      Duration since,
      Duration driven,
      double extraJoules) {

    double chargeAt(Duration now, Duration drivenNow) {
      double joules =
          data.idleWatts() * seconds(now.minus(since))
              + drivingWatts * seconds(drivenNow.minus(driven))
              + extraJoules;
      return Math.max(0, charge - joules / (data.wattHours() * JOULES_PER_WATT_HOUR));
    }

    private static double seconds(Duration time) {
      return time.toNanos() / NANOS;
    }
  }

  void put(
      String robot,
      PhysicalParameters.BatteryData data,
      double drivingWatts,
      double charge,
      Duration now) {
    batteries.put(robot, new Battery(data, drivingWatts, charge, now, Duration.ZERO, 0));
  }

  /** Full when it has none: it hangs on a wire. */
  double charge(String robot, Duration now, Duration driven) {
    return Optional.ofNullable(batteries.get(robot))
        .map(battery -> battery.chargeAt(now, driven))
        .orElse(1.0);
  }

  void charge(String robot, double charge, Duration now, Duration driven) {
    batteries.computeIfPresent(
        robot, (name, old) -> new Battery(old.data(), old.drivingWatts(), charge, now, driven, 0));
  }

  void draw(String robot, double joules) {
    batteries.computeIfPresent(
        robot,
        (name, old) ->
            new Battery(
                old.data(),
                old.drivingWatts(),
                old.charge(),
                old.since(),
                old.driven(),
                old.extraJoules() + joules));
  }
}
