package org.maestro.sim.world;

import java.time.Duration;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.rats.time.Clock;
import org.maestro.sim.scene.WorldEvent;

/**
 * Faults of devices: power cuts, defects, flaws and errors of measurement, and what is to happen
 * upon events. Guarded by the world's lock.
 */
public final class Faults {

  private static final double MILLIS_PER_HOUR = 3_600_000;

  private final Object lock;
  private final Clock clock;
  private final Set<String> dead = new TreeSet<>();
  private final Map<String, String> defects = new TreeMap<>();
  private final Map<String, Duration> frozenUntil = new TreeMap<>();
  private final Map<String, Double> slips = new TreeMap<>();
  private final Map<String, Distortion> distortions = new TreeMap<>();
  private final Map<String, Flaw> flaws = new TreeMap<>();
  private final Map<String, Double> shown = new TreeMap<>();
  private final Map<String, Astray> errors = new TreeMap<>();
  private final Map<String, Map<WorldEvent.Kind, List<Runnable>>> triggers = new TreeMap<>();

  Faults(Object lock, Clock clock) {
    this.lock = lock;
    this.clock = clock;
  }

  /** Whether it had power until now. */
  boolean die(String device) {
    synchronized (lock) {
      return dead.add(device);
    }
  }

  /** Whether it had no power until now. */
  boolean revive(String device) {
    synchronized (lock) {
      return dead.remove(device);
    }
  }

  boolean isAlive(String device) {
    synchronized (lock) {
      return !dead.contains(device);
    }
  }

  void breakDown(String device, String reason) {
    synchronized (lock) {
      defects.put(device, reason);
    }
  }

  void repair(String device) {
    synchronized (lock) {
      defects.remove(device);
    }
  }

  public Optional<String> defect(String device) {
    synchronized (lock) {
      return Optional.ofNullable(defects.get(device));
    }
  }

  /** Commands take effect after so many seconds only. */
  void freeze(String device, double seconds) {
    synchronized (lock) {
      frozenUntil.put(device, clock.now().plusMillis(Math.round(1e3 * seconds)));
    }
  }

  /** How long still; none when it is not frozen. */
  public Duration frozenFor(String device) {
    synchronized (lock) {
      Duration left = frozenUntil.getOrDefault(device, Duration.ZERO).minus(clock.now());
      return left.isNegative() ? Duration.ZERO : left;
    }
  }

  void slip(String robot, double share) {
    synchronized (lock) {
      slips.put(robot, share);
    }
  }

  /** The share of its way that the robot's wheels lose. */
  public double slipOf(String robot) {
    synchronized (lock) {
      return slips.getOrDefault(robot, 0.0);
    }
  }

  void distort(String sensor, double factor, double sharePerHour) {
    synchronized (lock) {
      distortions.put(sensor, new Distortion(factor, sharePerHour, clock.now()));
    }
  }

  /** By how much a sensor's measurement differs from the truth; 1 when it does not. */
  double distortion(String sensor) {
    synchronized (lock) {
      Distortion distortion = distortions.get(sensor);
      return distortion == null ? 1 : distortion.at(clock.now());
    }
  }

  public void flaw(String device, Flaw flaw) {
    synchronized (lock) {
      flaws.put(device, flaw);
    }
  }

  public Flaw flaw(String device) {
    synchronized (lock) {
      return flaws.getOrDefault(device, Flaw.NONE);
    }
  }

  /** From now on the robot errs so about where it is. */
  public void lead(String robot, Astray astray) {
    synchronized (lock) {
      errors.put(robot, astray);
    }
  }

  /** How far the robot errs about where it is. */
  public Astray astray(String robot) {
    synchronized (lock) {
      return errors.getOrDefault(robot, Astray.NOT);
    }
  }

  /** What the sensor makes of the true light, without noise. */
  public double shown(String sensor, double lux) {
    synchronized (lock) {
      return flaw(sensor) == Flaw.STUCK && shown.containsKey(sensor)
          ? shown.get(sensor)
          : remember(sensor, lux * distortion(sensor));
    }
  }

  private double remember(String sensor, double lux) {
    shown.put(sensor, lux);
    return lux;
  }

  private record Distortion(double factor, double sharePerHour, Duration since) {
    double at(Duration now) {
      return factor * (1 + sharePerHour * now.minus(since).toMillis() / MILLIS_PER_HOUR);
    }
  }

  void when(String device, WorldEvent.Kind kind, Runnable action) {
    synchronized (lock) {
      triggers
          .computeIfAbsent(device, name -> new EnumMap<>(WorldEvent.Kind.class))
          .computeIfAbsent(kind, any -> new ArrayList<>())
          .add(action);
    }
  }

  /** What is to happen now; it is forgotten thereby. */
  List<Runnable> triggered(String device, WorldEvent.Kind kind) {
    synchronized (lock) {
      Map<WorldEvent.Kind, List<Runnable>> ofDevice = triggers.get(device);
      return ofDevice != null && ofDevice.containsKey(kind) ? ofDevice.remove(kind) : List.of();
    }
  }
}
