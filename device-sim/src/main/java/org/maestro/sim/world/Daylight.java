package org.maestro.sim.world;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Glass;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Windows;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneSky;
import org.maestro.sim.sky.Clouds;
import org.maestro.sim.sky.Outdoors;
import org.maestro.sim.sky.Sky;
import org.maestro.sim.sky.Sun;

/**
 * Light that comes in by windows: diffusely from the glass and from the room's walls ({@link
 * Windows}), and straight from the sun where it shines through the glass upon a point. A shutter
 * lets through the share of it to which it is opened, evenly over the glass (slats; assumed). The
 * sky is looked at anew after some seconds. Guarded by the world's lock.
 */
final class Daylight {

  /** Meanwhile the sun moves by a fiftieth of a degree; assumed to be seen by nobody. */
  private static final Duration STEP = Duration.ofSeconds(5);

  private static final int MOST_KEPT = 20_000;

  private final List<Opening> openings = new ArrayList<>();
  private final Map<String, Double> openness = new TreeMap<>();
  private final Map<Position, double[]> shares = new HashMap<>();
  private final double northX;
  private final double northY;
  private Optional<Sky> sky;
  private Optional<FloorPlan> planOfShares = Optional.empty();
  private long step = -1;
  private Outdoors outdoors = Outdoors.DARK;

  /** A window with the devices that shade it. */
  private record Opening(Windows.Window window, List<String> shutters) {
    Glass glass() {
      return window.glass();
    }
  }

  /**
   * @param seed of clouds of which the scene does not state one
   * @param shutters whether they are there; else windows stand free
   */
  Daylight(Home home, Scene scene, long seed, boolean shutters) {
    Windows windows = new Windows(home);
    Map<String, List<String>> shading = new TreeMap<>();
    for (String device : shutters ? home.devices().keySet() : Set.<String>of()) {
      for (Windows.Window window : windows.shadedBy(device)) {
        shading.computeIfAbsent(window.name(), none -> new ArrayList<>()).add(device);
      }
    }
    windows
        .all()
        .forEach(
            (name, window) ->
                openings.add(new Opening(window, shading.getOrDefault(name, List.of()))));
    double north = Math.toRadians(scene.sky().map(SceneSky::northDegrees).orElse(0.0));
    this.northX = Math.cos(north);
    this.northY = Math.sin(north);
    this.sky = scene.sky().map(said -> said.sky(seed));
  }

  /** Whether light changes by itself. */
  boolean isAny() {
    return sky.isPresent();
  }

  /** Grows when the sky is looked at anew. */
  long version(Duration now) {
    return isAny() ? now.toMillis() / STEP.toMillis() : 0;
  }

  /** From now on the sky has these clouds. */
  void cloud(Clouds clouds) {
    sky = sky.map(present -> present.with(clouds));
    step = -1;
  }

  void setOpening(String shutter, double opening) {
    openness.put(shutter, opening);
  }

  /** The share of the glass that is free, 0 to 1. */
  double opening(String shutter) {
    return openness.getOrDefault(shutter, 0.0);
  }

  /** What windows add to the light on a horizontal surface within doors; lux. */
  double lux(Position point, FloorPlan plan, Duration now) {
    return lux(point, plan, now, this::free);
  }

  /** What they would add with all shutters open; lux. */
  double luxWithOpenShutters(Position point, FloorPlan plan, Duration now) {
    return lux(point, plan, now, opening -> 1);
  }

  private double lux(
      Position point, FloorPlan plan, Duration now, ToDoubleFunction<Opening> freeShare) {
    if (!isAny() || openings.isEmpty()) {
      return 0;
    }
    Outdoors light = outdoors(now);
    double[] factors = factors(point, plan);
    double lux = 0;
    for (int i = 0; i < factors.length; i++) {
      Opening opening = openings.get(i);
      double free = freeShare.applyAsDouble(opening);
      if (free > 0) {
        lux += free * (factors[i] * light.diffuseUponWall() + fromSun(opening, point, plan, light));
      }
    }
    return lux;
  }

  /** Upon level ground in the open; lux. */
  double outdoorLux(Duration now) {
    return outdoors(now).horizontal();
  }

  /** Upon the outside of windows from all sides; lux. */
  double diffuseUponWindows(Duration now) {
    return outdoors(now).diffuseUponWall();
  }

  /** Upon the outside of a window's glass straight from the sun; lux. */
  double sunUpon(Glass glass, Duration now) {
    return sunUpon(glass, outdoors(now));
  }

  private Outdoors outdoors(Duration now) {
    long current = version(now);
    if (current != step && isAny()) {
      step = current;
      outdoors = sky.orElseThrow().at(STEP.multipliedBy(current));
    }
    return outdoors;
  }

  private double free(Opening opening) {
    double free = 1;
    for (String shutter : opening.shutters()) {
      free *= opening(shutter);
    }
    return free;
  }

  private double[] factors(Position point, FloorPlan plan) {
    if (planOfShares.isEmpty() || planOfShares.get() != plan || shares.size() > MOST_KEPT) {
      shares.clear();
      planOfShares = Optional.of(plan);
    }
    return shares.computeIfAbsent(
        point,
        place ->
            openings.stream()
                .mapToDouble(
                    opening -> opening.window().share(place.x(), place.y(), place.z(), plan))
                .toArray());
  }

  /** Thrown about by the walls, and straight where the way to the sun leads through the glass. */
  private double fromSun(Opening opening, Position point, FloorPlan plan, Outdoors light) {
    double upon = sunUpon(opening.glass(), light);
    if (upon <= 0) {
      return 0;
    }
    double straight =
        isSunSeen(opening.glass(), point, plan, light.sun())
            ? light.directNormal() * light.sun().up()
            : 0;
    return upon * opening.window().reflectedShare(point.floor())
        + opening.glass().transmittance() * straight;
  }

  private double sunUpon(Glass glass, Outdoors light) {
    double x = -glass.inwardX();
    double y = -glass.inwardY();
    return light.sunUponWall(x * northY - y * northX, x * northX + y * northY);
  }

  private boolean isSunSeen(Glass glass, Position point, FloorPlan plan, Sun sun) {
    double sunX = sun.north() * northX + sun.east() * northY;
    double sunY = sun.north() * northY - sun.east() * northX;
    double before = glass.inside(point.floor());
    double towards = -(sunX * glass.inwardX() + sunY * glass.inwardY());
    if (before <= 0 || towards <= 0) {
      return false;
    }
    double way = before / towards;
    double height = point.z() + way * sun.up();
    Point2 foot = new Point2(point.x() + way * sunX, point.y() + way * sunY);
    return height >= glass.sill()
        && height <= glass.head()
        && glass.isInBreadth(foot)
        && glass.isSeenFrom(point.floor(), foot, plan);
  }
}
