package org.maestro.sim.world;

import java.util.List;
import java.util.function.Predicate;
import org.maestro.hal.Area;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Glass;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.Clock;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SimulationException;
import org.maestro.sim.sky.Clouds;

/**
 * The light at any point: of lamps that have power, the rest light of zones, and what comes in by
 * windows. Guarded by the world's lock.
 */
public final class Lighting {

  private final Object lock;
  private final Clock clock;
  private final Building building;
  private final Predicate<String> isAlive;
  private final LightField lamps = new LightField();
  private final Daylight daylight;

  /**
   * @param seed of clouds of which the scene does not state one
   * @param shutters whether they are there
   * @param isAlive whether a lamp has power
   */
  Lighting(
      Object lock,
      Clock clock,
      Home home,
      Scene scene,
      Building building,
      long seed,
      boolean shutters,
      Predicate<String> isAlive) {
    this.lock = lock;
    this.clock = clock;
    this.building = building;
    this.isAlive = isAlive;
    this.daylight = new Daylight(home, scene, seed, shutters);
    scene.openings().forEach(daylight::setOpening);
  }

  /** On a horizontal surface; lux. */
  double lux(Position point) {
    synchronized (lock) {
      double lux = lamps.lux(point, building.map().areaAt(point.floor()), building.plan(), isAlive);
      if (daylight.isAny()) {
        lux +=
            building.map().isIndoors(point.floor())
                ? daylight.lux(point, building.plan(), clock.now())
                : daylight.outdoorLux(clock.now());
      }
      return lux;
    }
  }

  /**
   * The same without the lamps that something stands before.
   *
   * @param hidden whether something stands between the point and a lamp
   */
  double luxInShadow(Position point, Predicate<Pose> hidden) {
    synchronized (lock) {
      return lux(point) - lamps.hiddenLux(point, building.plan(), isAlive, hidden);
    }
  }

  /** What would come in by windows to a point of a room, with all shutters open; lux. */
  double daylightWithOpenShutters(Position point) {
    synchronized (lock) {
      return daylight.luxWithOpenShutters(point, building.plan(), clock.now());
    }
  }

  /** Upon the outside of windows from all sides; lux. */
  public double diffuseUponWindows() {
    synchronized (lock) {
      return daylight.diffuseUponWindows(clock.now());
    }
  }

  /** Upon the outside of a window's glass straight from the sun; lux. */
  public double sunUpon(Glass glass) {
    synchronized (lock) {
      return daylight.sunUpon(glass, clock.now());
    }
  }

  /** Whether light comes in from outside, so that it may differ much from place to place. */
  public boolean hasDaylight() {
    return daylight.isAny();
  }

  /** Never the same when the light anywhere may have changed, by somebody or by itself. */
  public long version() {
    synchronized (lock) {
      return lamps.version() + daylight.version(clock.now());
    }
  }

  /** To be told when power or walls changed. */
  void changed() {
    synchronized (lock) {
      lamps.changed();
    }
  }

  public boolean hasLamp(String name) {
    synchronized (lock) {
      return lamps.hasLamp(name);
    }
  }

  public void put(String name, LampLight lamp) {
    synchronized (lock) {
      lamps.put(name, lamp);
    }
  }

  /**
   * @throws SimulationException when there is no such lamp
   */
  LampLight lamp(String name) {
    synchronized (lock) {
      return lamps.lamp(name);
    }
  }

  /**
   * @throws SimulationException when there is no such lamp
   */
  public void setLevel(String lamp, double level) {
    synchronized (lock) {
      lamps.put(lamp, lamps.lamp(lamp).at(level));
    }
  }

  /** Names of the lamps that hang over an area. */
  List<String> lampsOver(Area area) {
    synchronized (lock) {
      return lamps.lampsOver(area.outline()::contains);
    }
  }

  void setAmbient(String area, double lux) {
    synchronized (lock) {
      lamps.setAmbient(area, lux);
    }
  }

  /** The share of its windows that a shutter leaves free, 0 to 1. */
  double opening(String shutter) {
    synchronized (lock) {
      return daylight.opening(shutter);
    }
  }

  public void setOpening(String shutter, double opening) {
    synchronized (lock) {
      daylight.setOpening(shutter, opening);
      lamps.changed();
    }
  }

  /** From now on the sky has these clouds. */
  void cloud(Clouds clouds) {
    synchronized (lock) {
      daylight.cloud(clouds);
      lamps.changed();
    }
  }
}
