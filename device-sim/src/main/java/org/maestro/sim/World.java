package org.maestro.sim;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.hal.Area;
import org.maestro.hal.Position;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.home.FloorPlan;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Point2;
import org.maestro.ontology.home.Segment;
import org.maestro.rats.time.Clock;

/**
 * The ground truth: floor, light, bodies, and which device has power. Drivers act on it on the
 * clock's thread; any thread may read and change it, since every method holds the world's lock.
 * Listeners are told outside the lock, on the thread that caused the event.
 */
public final class World {

  /** Two things are next to each other up to this horizontal distance; metres. */
  public static final double NEXT_TO_METRES = 0.6;

  private static final double DROP_METRES = 0.1;
  private static final int DROP_DIRECTIONS = 8;

  private final Clock clock;
  private final FloorMap map;
  private final Map<String, Body> bodies = new TreeMap<>();
  private final Map<String, LampLight> lamps = new LinkedHashMap<>();
  private final Map<String, Double> ambient = new TreeMap<>();
  private final Set<String> openDoors = new TreeSet<>();
  private final Map<String, Drive> drives = new TreeMap<>();
  private final Map<String, List<PathPoint>> paths = new TreeMap<>();
  private final Set<String> dead = new TreeSet<>();
  private final Map<String, String> broken = new TreeMap<>();
  private final Map<String, Map<WorldEvent.Kind, List<Runnable>>> triggers = new TreeMap<>();
  private final List<WorldEvent.Listener> listeners = new CopyOnWriteArrayList<>();
  private FloorPlan plan;
  private long lightVersion;

  World(Home home, Scene scene, Clock clock) {
    this.clock = clock;
    this.map = new FloorMap(home);
    for (String name : home.individuals().keySet()) {
      Scene.Entry entry = scene.of(name);
      entry
          .position()
          .ifPresent(
              position ->
                  bodies.put(
                      name,
                      new Body(
                          name,
                          position,
                          entry.radius().orElse(Body.USUAL_RADIUS),
                          entry.mass().orElse(Body.USUAL_MASS),
                          entry.hidden(),
                          Optional.empty())));
      entry.ambientLux().ifPresent(lux -> ambient.put(name, lux));
      entry.diesWhen().ifPresent(kind -> when(name, kind, () -> die(name)));
      if (entry.dead()) {
        dead.add(name);
      }
    }
    for (String door : map.doors().keySet()) {
      if (scene.of(door).open().orElse(true)) {
        openDoors.add(door);
      }
    }
    this.plan = map.plan(openDoors);
  }

  // What is where

  /** Where a thing is, a held one where its holder is; empty when it is nowhere in this world. */
  public synchronized Optional<Position> position(String name) {
    Body body = bodies.get(name);
    if (body == null) {
      return Optional.empty();
    }
    if (body.holder().isPresent()) {
      return position(body.holder().get());
    }
    Drive drive = drives.get(name);
    return Optional.of(
        drive == null ? body.position() : Position.onFloor(drive.positionAt(clock.now())));
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
    return Optional.ofNullable(bodies.get(thing)).flatMap(Body::holder);
  }

  /** What it holds. */
  public synchronized Optional<String> held(String robot) {
    return bodies.values().stream()
        .filter(body -> body.holder().equals(Optional.of(robot)))
        .map(Body::name)
        .findFirst();
  }

  /** The zone (of a home without zones: the room) in which it is. */
  public synchronized Optional<String> zone(String name) {
    return position(name).flatMap(place -> map.areaAt(place.floor())).map(Area::name);
  }

  /** Where a robot went, corner by corner, up to now. */
  public synchronized List<PathPoint> path(String robot) {
    List<PathPoint> path = new ArrayList<>(paths.getOrDefault(robot, List.of()));
    Drive drive = drives.get(robot);
    if (drive != null) {
      path.addAll(drive.pathUntil(clock.now()));
    }
    return List.copyOf(path);
  }

  /** Names of all that is in the world, robots too. */
  public synchronized Set<String> bodies() {
    return new TreeSet<>(bodies.keySet());
  }

  // Light

  /** Light on a horizontal surface; lux. */
  public synchronized double lux(Position point) {
    double lux =
        map.areaAt(point.floor()).map(area -> ambient.getOrDefault(area.name(), 0.0)).orElse(0.0);
    for (Map.Entry<String, LampLight> lamp : lamps.entrySet()) {
      if (!dead.contains(lamp.getKey())) {
        lux += lamp.getValue().lux(point, plan);
      }
    }
    return lux;
  }

  /**
   * Light at a zone's reference point; lux.
   *
   * @throws SimulationException when there is no such zone
   */
  public double lux(String zone) {
    return lux(Position.onFloor(area(zone).reference()));
  }

  /** 0 when the lamp has no power. */
  public synchronized double lampLevel(String lamp) {
    return dead.contains(lamp) ? 0 : lamp(lamp).level();
  }

  public void setAmbient(String zone, double lux) {
    synchronized (this) {
      ambient.put(area(zone).name(), lux);
      lightVersion++;
    }
  }

  /**
   * A lamp now gives another share of its stated light.
   *
   * @param strength 1 is all
   */
  public synchronized void weaken(String lamp, double strength) {
    lamps.put(lamp, lamp(lamp).weakened(strength));
    lightVersion++;
  }

  // Changes by hand

  /** Puts a thing or person somewhere, out of whatever hand it is in. */
  public void moveByHand(String thing, Position place) {
    synchronized (this) {
      bodies.put(thing, body(thing).at(place));
    }
    tell(WorldEvent.Kind.MOVED, thing, Optional.empty());
  }

  /** Puts a thing into a cupboard where it stands, or takes it out. */
  public synchronized void hide(String thing, boolean hidden) {
    bodies.put(thing, body(thing).hidden(hidden));
  }

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
      lightVersion++;
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
    Optional<String> dropped;
    synchronized (this) {
      if (!dead.add(device)) {
        return;
      }
      stop(device);
      dropped = held(device);
      dropped.ifPresent(thing -> bodies.put(thing, body(thing).at(besideRobot(device))));
      lightVersion++;
    }
    dropped.ifPresent(thing -> tell(WorldEvent.Kind.DROPPED, device, Optional.of(thing)));
    tell(WorldEvent.Kind.DIED, device, Optional.empty());
  }

  /** The device has power again; a lamp then is off. */
  public void revive(String device) {
    synchronized (this) {
      if (!dead.remove(device)) {
        return;
      }
      if (lamps.containsKey(device)) {
        lamps.put(device, lamp(device).at(0));
      }
      lightVersion++;
    }
    tell(WorldEvent.Kind.REVIVED, device, Optional.empty());
  }

  public synchronized boolean isAlive(String device) {
    return !dead.contains(device);
  }

  /** From now on every command to the device fails, until {@link #repair}. */
  public synchronized void breakDown(String device, String reason) {
    broken.put(device, reason);
  }

  public synchronized void repair(String device) {
    broken.remove(device);
  }

  synchronized Optional<String> defect(String device) {
    return Optional.ofNullable(broken.get(device));
  }

  /**
   * Runs the action once, the next time that this happens to the device; a command so met by {@link
   * #die} has no effect.
   */
  public synchronized void when(String device, WorldEvent.Kind kind, Runnable action) {
    triggers
        .computeIfAbsent(device, name -> new EnumMap<>(WorldEvent.Kind.class))
        .computeIfAbsent(kind, any -> new ArrayList<>())
        .add(action);
  }

  /** Tells the listener of everything from now on. */
  public void listen(WorldEvent.Listener listener) {
    listeners.add(listener);
  }

  // What drivers do

  void tell(WorldEvent.Kind kind, String subject, Optional<String> thing) {
    List<Runnable> due;
    synchronized (this) {
      Map<WorldEvent.Kind, List<Runnable>> ofSubject = triggers.getOrDefault(subject, Map.of());
      due = ofSubject.containsKey(kind) ? ofSubject.remove(kind) : List.of();
    }
    WorldEvent event = new WorldEvent(clock.now(), kind, subject, thing);
    listeners.forEach(listener -> listener.happened(event));
    due.forEach(Runnable::run);
  }

  synchronized void addLamp(String name, LampLight lamp) {
    lamps.put(name, lamp);
    lightVersion++;
  }

  synchronized void setLevel(String lamp, double level) {
    lamps.put(lamp, lamp(lamp).at(level));
    lightVersion++;
  }

  synchronized LampLight lamp(String name) {
    LampLight lamp = lamps.get(name);
    if (lamp == null) {
      throw new SimulationException("There is no lamp " + name + "; there are " + lamps.keySet());
    }
    return lamp;
  }

  /** Grows with every change of light, so that what was computed from it can be kept meanwhile. */
  synchronized long lightVersion() {
    return lightVersion;
  }

  synchronized FloorPlan plan() {
    return plan;
  }

  FloorMap map() {
    return map;
  }

  synchronized List<Segment> walls() {
    return FloorMap.walls(plan);
  }

  /** What stands in the robot's way: not itself, not what it holds. */
  synchronized List<Obstacle> obstacles(String robot) {
    return obstaclesWithout(Set.of(robot));
  }

  synchronized List<Obstacle> obstaclesWithout(Set<String> names) {
    List<Obstacle> obstacles = new ArrayList<>();
    for (Body body : bodies.values()) {
      if (body.isObstacle() && !names.contains(body.name())) {
        Point2 place = position(body.name()).orElseThrow().floor();
        obstacles.add(new Obstacle(place, body.radius()));
      }
    }
    return obstacles;
  }

  synchronized Body body(String name) {
    Body body = bodies.get(name);
    if (body == null) {
      throw new SimulationException(
          name + " is nowhere in this world; there are " + bodies.keySet());
    }
    return body;
  }

  synchronized Optional<Body> findBody(String name) {
    return Optional.ofNullable(bodies.get(name));
  }

  synchronized void put(Body body) {
    bodies.put(body.name(), body);
  }

  synchronized Optional<Drive> drive(String robot) {
    return Optional.ofNullable(drives.get(robot));
  }

  synchronized void start(String robot, Drive drive) {
    drives.put(robot, drive);
  }

  /** Ends a drive where the robot is now. */
  synchronized void stop(String robot) {
    Drive drive = drives.get(robot);
    if (drive != null) {
      paths.computeIfAbsent(robot, name -> new ArrayList<>()).addAll(drive.pathUntil(clock.now()));
      Position place = Position.onFloor(drive.positionAt(clock.now()));
      drives.remove(robot);
      bodies.put(robot, body(robot).at(place));
    }
  }

  /** Where something lands that a robot lets go of: before it, where no wall is between. */
  private Position besideRobot(String robot) {
    Point2 middle = position(robot).orElseThrow().floor();
    double distance = body(robot).radius() + DROP_METRES;
    for (int i = 0; i < DROP_DIRECTIONS; i++) {
      double angle = 2 * Math.PI * i / DROP_DIRECTIONS;
      Point2 place =
          new Point2(
              middle.x() + distance * Math.cos(angle), middle.y() + distance * Math.sin(angle));
      boolean free =
          obstacles(robot).stream()
              .allMatch(
                  obstacle -> obstacle.middle().distance(place) > obstacle.radius() + DROP_METRES);
      if (free && map.areaAt(place).isPresent() && !plan.isBlocked(middle, place)) {
        return Position.onFloor(place);
      }
    }
    return Position.onFloor(middle);
  }

  private Area area(String zone) {
    return map.areas().stream()
        .filter(area -> area.name().equals(zone))
        .findFirst()
        .orElseThrow(() -> new SimulationException("There is no zone " + zone + " in this home."));
  }
}
