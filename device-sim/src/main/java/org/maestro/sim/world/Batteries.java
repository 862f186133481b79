package org.maestro.sim.world;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.rats.time.Clock;
import org.maestro.sim.parameters.BatteryData;

/**
 * The charge of robots' batteries: at each moment it is reckoned from what was drawn since the last
 * charge, so that nothing has to happen meanwhile. Guarded by the world's lock.
 */
public final class Batteries {

  private static final double JOULES_PER_WATT_HOUR = 3600;
  private static final double NANOS = 1e9;

  private final Object lock;
  private final Clock clock;
  private final Whereabouts whereabouts;
  private final Map<String, Battery> batteries = new TreeMap<>();

  /**
   * @param whereabouts knows for how long robots have driven
   */
  Batteries(Object lock, Clock clock, Whereabouts whereabouts) {
    this.lock = lock;
    this.clock = clock;
    this.whereabouts = whereabouts;
  }

  /**
   * @param charge share that was in it then
   * @param since the moment of that
   * @param driven for how long the robot had driven until then
   * @param extraJoules drawn since by what is neither idle nor driving
   * @param filledWatts that come in meanwhile
   */
  private record Battery(
      BatteryData data,
      double drivingWatts,
      double charge,
      Duration since,
      Duration driven,
      double extraJoules,
      double filledWatts) {

    double chargeAt(Duration now, Duration drivenNow) {
      double joules =
          (data.idleWatts() - filledWatts) * seconds(now.minus(since))
              + drivingWatts * seconds(drivenNow.minus(driven))
              + extraJoules;
      return Math.max(0, Math.min(1, charge - joules / (data.wattHours() * JOULES_PER_WATT_HOUR)));
    }

    private static double seconds(Duration time) {
      return time.toNanos() / NANOS;
    }
  }

  public void put(String robot, BatteryData data, double drivingWatts, double charge) {
    synchronized (lock) {
      batteries.put(
          robot, new Battery(data, drivingWatts, charge, clock.now(), Duration.ZERO, 0, 0));
    }
  }

  /** Full when it has none: it hangs on a wire. */
  double charge(String robot) {
    synchronized (lock) {
      return Optional.ofNullable(batteries.get(robot))
          .map(battery -> battery.chargeAt(clock.now(), whereabouts.driven(robot)))
          .orElse(1.0);
    }
  }

  void charge(String robot, double charge) {
    synchronized (lock) {
      Duration now = clock.now();
      Duration driven = whereabouts.driven(robot);
      batteries.computeIfPresent(
          robot,
          (name, old) ->
              new Battery(
                  old.data(), old.drivingWatts(), charge, now, driven, 0, old.filledWatts()));
    }
  }

  /** From now on so much comes in; watts, 0 ends it. */
  public void plug(String robot, double watts) {
    synchronized (lock) {
      Duration now = clock.now();
      double charge = charge(robot);
      Duration driven = whereabouts.driven(robot);
      batteries.computeIfPresent(
          robot,
          (name, old) ->
              new Battery(old.data(), old.drivingWatts(), charge, now, driven, 0, watts));
    }
  }

  public void draw(String robot, double joules) {
    synchronized (lock) {
      batteries.computeIfPresent(
          robot,
          (name, old) ->
              new Battery(
                  old.data(),
                  old.drivingWatts(),
                  old.charge(),
                  old.since(),
                  old.driven(),
                  old.extraJoules() + joules,
                  old.filledWatts()));
    }
  }
}
