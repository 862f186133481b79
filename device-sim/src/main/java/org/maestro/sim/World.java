package org.maestro.sim;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;
import org.maestro.hal.Area;
import org.maestro.hal.Position;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.home.FloorPlan;
import org.maestro.ontology.home.Glass;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Pose;
import org.maestro.ontology.home.Segment;
import org.maestro.rats.time.Clock;
import org.maestro.sim.sky.Clouds;

/**
 * The ground truth: floor, light, bodies, and which device has power. Drivers act on it on the
 * clock's thread; any thread may read and change it, since every method holds the world's lock.
 * Listeners are told outside the lock, on the thread that caused the event.
 */
public final class World {

  /** Two things are next to each other up to this horizontal distance; metres. */
  public static final double NEXT_TO_METRES = 0.6;

  private final Clock clock;
  private final FloorMap map;
  private final Whereabouts whereabouts;
  private final LightField light = new LightField();
  private final Daylight daylight;
  private final Looks looks;
  private final Faults faults = new Faults();
  private final Batteries batteries = new Batteries();
  private final Set<String> openDoors = new TreeSet<>();
  private final List<WorldEvent.Listener> listeners = new CopyOnWriteArrayList<>();
  private FloorPlan plan;
  private List<Segment> walls;
  private boolean ended;

  World(Home home, Scene scene, Clock clock, long seed, PhysicalParameters parameters) {
    this.clock = clock;
    this.map = new FloorMap(home);
    this.daylight = new Daylight(home, scene, seed, parameters.shutters());
    this.looks = new Looks(home, scene);
    scene.openings().forEach(daylight::setOpening);
    this.whereabouts = new Whereabouts(clock);
    home.individuals().keySet().forEach(name -> begin(name, scene.of(name)));
    for (String door : map.doors().keySet()) {
      if (scene.of(door).open().orElse(true)) {
        openDoors.add(door);
      }
    }
    this.plan = map.plan(openDoors);
    this.walls = FloorMap.walls(plan);
  }

  private void begin(String name, Scene.Entry entry) {
    entry
        .position()
        .ifPresent(
            place ->
                whereabouts.put(
                    new Body(
                        name,
                        place,
                        entry.radius().orElse(Body.USUAL_RADIUS),
                        entry.mass().orElse(Body.USUAL_MASS),
                        entry.hidden(),
                        Optional.empty())));
    entry.ambientLux().ifPresent(lux -> light.setAmbient(name, lux));
    entry.diesWhen().ifPresent(kind -> faults.when(name, kind, () -> die(name)));
    if (entry.dead()) {
      faults.die(name);
    }
  }

  // What is where

  /** Where a thing is, a held one where its holder is; empty when it is nowhere in this world. */
  public synchronized Optional<Position> position(String name) {
    return whereabouts.position(name);
  }

  /** Horizontal distance; metres, infinite when one of them is nowhere. */
  public synchronized double distance(String first, String second) {
    Optional<Position> from = position(first);
    Optional<Position> to = position(second);
    return from.isPresent() && to.isPresent()
        ? from.get().floor().distance(to.get().floor())
        : Double.POSITIVE_INFINITY;
  }

  /** Whether both stand next to each other, neither held by anybody. */
  public synchronized boolean isNextTo(String first, String second) {
    return holder(first).isEmpty()
        && holder(second).isEmpty()
        && distance(first, second) <= NEXT_TO_METRES;
  }

  /** Who holds it. */
  public synchronized Optional<String> holder(String thing) {
    return whereabouts.find(thing).flatMap(Body::holder);
  }

  /** Of the circle around it on the floor; metres. */
  public synchronized double radius(String name) {
    return whereabouts.body(name).radius();
  }

  /** Whether it is in a cupboard. */
  public synchronized boolean isHidden(String thing) {
    return whereabouts.body(thing).hidden();
  }

  /** What it holds. */
  public synchronized Optional<String> held(String robot) {
    return whereabouts.held(robot);
  }

  /** The zone (of a home without zones: the room) in which it is. */
  public synchronized Optional<String> zone(String name) {
    return position(name).flatMap(place -> map.areaAt(place.floor())).map(Area::name);
  }

  /** In which direction it drives or last drove, from x towards y; radians. */
  synchronized double heading(String name) {
    return whereabouts.heading(name);
  }

  /** Where a robot went, corner by corner, up to now. */
  public synchronized List<PathPoint> path(String robot) {
    return whereabouts.path(robot);
  }

  /** Names of all that is in the world, robots too. */
  public synchronized Set<String> bodies() {
    return whereabouts.names();
  }

  // Light

  /** Light on a horizontal surface; lux. */
  public synchronized double lux(Position point) {
    double lux = light.lux(point, map.areaAt(point.floor()), plan, faults::isAlive);
    if (daylight.isAny()) {
      lux +=
          map.isIndoors(point.floor())
              ? daylight.lux(point, plan, clock.now())
              : daylight.outdoorLux(clock.now());
    }
    return lux;
  }

  /**
   * The same without the lamps that something stands before.
   *
   * @param hidden whether something stands between the point and a lamp
   */
  synchronized double luxInShadow(Position point, Predicate<Pose> hidden) {
    return lux(point) - light.hiddenLux(point, plan, faults::isAlive, hidden);
  }

  /**
   * Light at a zone's reference point; lux.
   *
   * @throws SimulationException when there is no such zone
   */
  public double lux(String zone) {
    return lux(Position.onFloor(map.area(zone).reference()));
  }

  /** 0 when the lamp has no power. */
  public synchronized double lampLevel(String lamp) {
    return isAlive(lamp) ? light.lamp(lamp).level() : 0;
  }

  /**
   * @throws SimulationException when there is no such zone
   */
  public synchronized void setAmbient(String zone, double lux) {
    light.setAmbient(map.area(zone).name(), lux);
  }

  /** The share of its windows that a shutter leaves free, 0 to 1. */
  public synchronized double opening(String shutter) {
    return daylight.opening(shutter);
  }

  /** What would come in by windows to a point of a room, with all shutters open; lux. */
  public synchronized double daylightWithOpenShutters(Position point) {
    return daylight.luxWithOpenShutters(point, plan, clock.now());
  }

  /** From now on clouds hide so much of the sky, all the time; 0 to 1. */
  public synchronized void setClouds(double cover) {
    daylight.cloud(Clouds.steady(cover));
    light.changed();
  }

  /**
   * A lamp now gives another share of its stated light.
   *
   * @param strength 1 is all
   */
  public synchronized void weaken(String lamp, double strength) {
    light.put(lamp, light.lamp(lamp).weakened(strength));
  }

  // Changes by hand

  /** Puts a thing or person somewhere, out of whatever hand it is in. */
  public void moveByHand(String thing, Position place) {
    synchronized (this) {
      whereabouts.stop(thing);
      whereabouts.put(whereabouts.body(thing).at(place));
    }
    tell(WorldEvent.Kind.MOVED, thing, Optional.empty());
  }

  /** Puts a thing into a cupboard where it stands, or takes it out. */
  public synchronized void hide(String thing, boolean hidden) {
    whereabouts.put(whereabouts.body(thing).hidden(hidden));
  }

  /**
   * @throws SimulationException when there is no such door
   */
  public void setDoor(String door, boolean open) {
    synchronized (this) {
      if (!map.doors().containsKey(door)) {
        throw new SimulationException(
            "There is no door " + door + "; there are " + map.doors().keySet());
      }
      if (open) {
        openDoors.add(door);
      } else {
        openDoors.remove(door);
      }
      plan = map.plan(openDoors);
      walls = FloorMap.walls(plan);
      light.changed();
    }
    tell(open ? WorldEvent.Kind.OPENED : WorldEvent.Kind.CLOSED, door, Optional.empty());
  }

  public synchronized boolean isOpen(String door) {
    return openDoors.contains(door);
  }

  // Power and faults

  /**
   * The device loses its power: it stands still, lets go of what it holds, gives no light and
   * leaves the bus without goodbye.
   */
  public void die(String device) {
    synchronized (this) {
      if (!faults.die(device)) {
        return;
      }
      whereabouts.stop(device);
      light.changed();
    }
    drop(device);
    tell(WorldEvent.Kind.DIED, device, Optional.empty());
  }

  /** What the robot holds falls to the floor beside it. */
  public void drop(String robot) {
    Optional<String> dropped;
    synchronized (this) {
      dropped = held(robot);
      dropped.ifPresent(
          thing ->
              whereabouts.put(
                  whereabouts
                      .body(thing)
                      .at(
                          LandingSpot.beside(
                              position(robot).orElseThrow().floor(),
                              body(robot).radius(),
                              obstacles(robot),
                              map,
                              plan))));
    }
    dropped.ifPresent(thing -> tell(WorldEvent.Kind.DROPPED, robot, Optional.of(thing)));
  }

  /** Commands to the device take effect after so many seconds only. */
  public synchronized void freeze(String device, double seconds) {
    faults.freeze(device, clock.now().plusMillis(Math.round(1e3 * seconds)));
  }

  /**
   * From now on what a sensor measures is so many times the truth, and by a share more every hour.
   *
   * @param factor 1 is the truth
   */
  public synchronized void distort(String sensor, double factor, double sharePerHour) {
    faults.distort(sensor, factor, sharePerHour, clock.now());
  }

  /**
   * From now on the robot's wheels lose a share of their way.
   *
   * @param share 0 to 1
   */
  public synchronized void slip(String robot, double share) {
    faults.slip(robot, share);
  }

  /** What is left in a robot's battery, 0 to 1; 1 when it has none. */
  public synchronized double charge(String robot) {
    return batteries.charge(robot, clock.now(), whereabouts.driven(robot));
  }

  /**
   * Charges or drains a battery at once. A robot without power still has to be revived.
   *
   * @param share 0 to 1
   */
  public synchronized void charge(String robot, double share) {
    batteries.charge(robot, share, clock.now(), whereabouts.driven(robot));
  }

  /** All lamps over a zone lose their power, and no other light is left there but the day's. */
  public void darken(String zone) {
    Area area;
    List<String> lamps;
    synchronized (this) {
      area = map.area(zone);
      light.setAmbient(zone, 0);
      lamps = light.lampsOver(area.outline()::contains);
    }
    lamps.forEach(this::die);
  }

  /** The device has power again; a lamp then is off. */
  public void revive(String device) {
    synchronized (this) {
      if (!faults.revive(device)) {
        return;
      }
      if (light.hasLamp(device)) {
        light.put(device, light.lamp(device).at(0));
      }
    }
    tell(WorldEvent.Kind.REVIVED, device, Optional.empty());
  }

  public synchronized boolean isAlive(String device) {
    return faults.isAlive(device);
  }

  /** From now on every command to the device fails, until {@link #repair}. */
  public synchronized void breakDown(String device, String reason) {
    faults.breakDown(device, reason);
  }

  public synchronized void repair(String device) {
    faults.repair(device);
  }

  /**
   * Runs the action once, the next time that this happens to the device; a command so met by {@link
   * #die} has no effect.
   */
  public synchronized void when(String device, WorldEvent.Kind kind, Runnable action) {
    faults.when(device, kind, action);
  }

  /** Tells the listener of everything from now on. */
  public void listen(WorldEvent.Listener listener) {
    listeners.add(listener);
  }

  // What drivers need

  /** Nothing goes on by itself from now on. */
  synchronized void end() {
    ended = true;
  }

  synchronized boolean hasEnded() {
    return ended;
  }

  void tell(WorldEvent.Kind kind, String subject, Optional<String> thing) {
    List<Runnable> due;
    synchronized (this) {
      due = faults.triggered(subject, kind);
    }
    WorldEvent event = new WorldEvent(clock.now(), kind, subject, thing);
    listeners.forEach(listener -> listener.happened(event));
    due.forEach(Runnable::run);
  }

  synchronized Optional<String> defect(String device) {
    return faults.defect(device);
  }

  /** How long the device is frozen still; none when it is not. */
  synchronized Duration frozenFor(String device) {
    return faults.frozenFor(device, clock.now());
  }

  /** By how much a sensor's measurement differs from the truth; 1 when it does not. */
  synchronized double distortion(String sensor) {
    return faults.distortion(sensor, clock.now());
  }

  synchronized void addLamp(String name, LampLight lamp) {
    light.put(name, lamp);
  }

  synchronized void setLevel(String lamp, double level) {
    light.put(lamp, light.lamp(lamp).at(level));
  }

  synchronized void setOpening(String shutter, double opening) {
    daylight.setOpening(shutter, opening);
    light.changed();
  }

  synchronized double diffuseUponWindows() {
    return daylight.diffuseUponWindows(clock.now());
  }

  synchronized double sunUpon(Glass glass) {
    return daylight.sunUpon(glass, clock.now());
  }

  /** Never the same when the light anywhere may have changed, by somebody or by itself. */
  synchronized long lightVersion() {
    return light.version() + daylight.version(clock.now());
  }

  synchronized FloorPlan plan() {
    return plan;
  }

  /** Whether light comes in from outside, so that it may differ much from place to place. */
  boolean hasDaylight() {
    return daylight.isAny();
  }

  /** Where all that is neither hidden nor held is. */
  synchronized List<Position> placesInTheOpen() {
    return whereabouts.names().stream()
        .filter(name -> whereabouts.body(name).isInTheOpen())
        .flatMap(name -> whereabouts.position(name).stream())
        .toList();
  }

  Looks looks() {
    return looks;
  }

  FloorMap map() {
    return map;
  }

  synchronized List<Segment> walls() {
    return walls;
  }

  synchronized double slipOf(String robot) {
    return faults.slip(robot);
  }

  synchronized boolean hasLamp(String name) {
    return light.hasLamp(name);
  }

  Duration now() {
    return clock.now();
  }

  synchronized void putBattery(
      String robot, PhysicalParameters.BatteryData data, double drivingWatts, double charge) {
    batteries.put(robot, data, drivingWatts, charge, clock.now());
  }

  synchronized void draw(String robot, double joules) {
    batteries.draw(robot, joules);
  }

  /** Who moves by itself, but for one. */
  synchronized Set<String> movingWithout(String robot) {
    Set<String> others = whereabouts.moving();
    others.remove(robot);
    return others;
  }

  /** What stands where a thing is to be put. */
  synchronized Optional<String> occupant(Position place, String thing) {
    return whereabouts.occupant(place, whereabouts.body(thing));
  }

  /** What stands in the robot's way: not itself, not what it holds. */
  synchronized List<Obstacle> obstacles(String robot) {
    return whereabouts.obstaclesWithout(Set.of(robot));
  }

  synchronized Body body(String name) {
    return whereabouts.body(name);
  }

  synchronized Optional<Body> findBody(String name) {
    return whereabouts.find(name);
  }

  synchronized void put(Body body) {
    whereabouts.put(body);
  }

  synchronized Optional<Drive> drive(String robot) {
    return whereabouts.drive(robot);
  }

  synchronized void start(String robot, Drive drive) {
    whereabouts.start(robot, drive);
  }

  synchronized void stop(String robot) {
    whereabouts.stop(robot);
  }
}
