package org.maestro.sim.world;

import java.time.Duration;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.maestro.rats.time.Clock;
import org.maestro.sim.parameters.ClimateData;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneSky;

/**
 * How warm the air of each zone is: it follows, by the model of {@link ClimateData}, from how warm
 * it is outdoors and from the thermostats of the zone. It is reckoned when it is asked for or a
 * thermostat changes, and costs nothing in between. Guarded by the world's lock.
 */
public final class Climate {

  private static final double NANOS = 1e9;

  private final Object lock;
  private final Clock clock;
  private final Scene scene;
  private final ClimateData data;
  private final Predicate<String> isAlive;
  private final double outside;
  private final Map<String, Air> zones = new TreeMap<>();
  private final Map<String, Thermostat> thermostats = new TreeMap<>();

  /** The air of a zone at a moment; the seconds are counted since the beginning. */
  private record Air(double celsius, boolean heated, double seconds) {}

  /**
   * @param set what it is set to; empty while it is not set
   * @param kept what it kept since its last change; empty without power
   */
  private record Thermostat(String zone, Supplier<OptionalDouble> set, OptionalDouble kept) {}

  /**
   * @param isAlive whether a device has power
   */
  Climate(Object lock, Clock clock, Scene scene, ClimateData data, Predicate<String> isAlive) {
    this.lock = lock;
    this.clock = clock;
    this.scene = scene;
    this.data = data;
    this.isAlive = isAlive;
    this.outside =
        scene
            .sky()
            .map(SceneSky::celsius)
            .orElse(OptionalDouble.empty())
            .orElse(data.outsideCelsius());
  }

  /** How warm it is outdoors; degrees Celsius. */
  public double outside() {
    return outside;
  }

  /** How warm it is in a zone; degrees Celsius. */
  double celsius(String zone) {
    synchronized (lock) {
      return now(zone).celsius();
    }
  }

  /**
   * A zone is kept as warm as a thermostat is set.
   *
   * @param set degrees Celsius; asked whenever something happens to the device
   */
  public void keep(String zone, String device, Supplier<OptionalDouble> set) {
    synchronized (lock) {
      now(zone);
      thermostats.put(device, changed(device, new Thermostat(zone, set, OptionalDouble.empty())));
    }
  }

  /** Something happened to a device: what was kept until now counts until now. */
  void happened(String device) {
    synchronized (lock) {
      Thermostat thermostat = thermostats.get(device);
      if (thermostat != null) {
        now(thermostat.zone());
        thermostats.put(device, changed(device, thermostat));
      }
    }
  }

  private Thermostat changed(String device, Thermostat thermostat) {
    OptionalDouble kept = isAlive.test(device) ? thermostat.set().get() : OptionalDouble.empty();
    return new Thermostat(thermostat.zone(), thermostat.set(), kept);
  }

  /** The highest target of the zone's thermostats counts: heat adds up, and cold does not. */
  private OptionalDouble target(String zone) {
    return thermostats.values().stream()
        .filter(thermostat -> thermostat.zone().equals(zone))
        .flatMapToDouble(thermostat -> thermostat.kept().stream())
        .max();
  }

  private Air now(String zone) {
    double now = seconds(clock.now());
    OptionalDouble target = target(zone);
    Air air = zones.computeIfAbsent(zone, name -> new Air(atFirst(name), false, 0));
    while (air.seconds() < now) {
      air = later(regulated(air, target), target, now);
    }
    zones.put(zone, air);
    return air;
  }

  private double atFirst(String zone) {
    return scene.of(zone).celsius().orElse(data.insideCelsius());
  }

  private Air regulated(Air air, OptionalDouble target) {
    if (target.isEmpty()) {
      return new Air(air.celsius(), false, air.seconds());
    }
    double bound = bound(air.heated(), target.getAsDouble());
    boolean isReached = air.heated() ? air.celsius() >= bound : air.celsius() <= bound;
    return new Air(air.celsius(), air.heated() != isReached, air.seconds());
  }

  private double bound(boolean heated, double target) {
    return heated ? target + data.hysteresis() : target - data.hysteresis();
  }

  /** As it is at that time, or when the thermostat next switches, if that is before. */
  private Air later(Air air, OptionalDouble target, double until) {
    double limit = outside + (air.heated() ? data.mostAboveOutside() : 0);
    double lag = data.lagSeconds();
    if (target.isPresent()) {
      double bound = bound(air.heated(), target.getAsDouble());
      double share = (bound - limit) / (air.celsius() - limit);
      double switched = air.seconds() - lag * Math.log(share);
      if (share > 0 && share < 1 && switched <= until) {
        return new Air(bound, air.heated(), switched);
      }
    }
    double left = Math.exp((air.seconds() - until) / lag);
    return new Air(limit + (air.celsius() - limit) * left, air.heated(), until);
  }

  private static double seconds(Duration time) {
    return time.toNanos() / NANOS;
  }
}
