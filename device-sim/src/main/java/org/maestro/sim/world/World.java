package org.maestro.sim.world;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.hal.Area;
import org.maestro.hal.Position;
import org.maestro.hal.sight.Paint;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.Clock;
import org.maestro.sim.parameters.PersonData;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SimulationException;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.sky.Clouds;

/**
 * The ground truth: floor, light, bodies, and which device has power. Drivers act on its parts on
 * the clock's thread; any thread may read and change it, since every method of it and of its parts
 * holds the world's lock. Listeners are told outside the lock, on the thread that caused the event.
 */
public final class World {

  /** Two things are next to each other up to this horizontal distance; metres. */
  public static final double NEXT_TO_METRES = 0.6;

  private static final double NANOS = 1e9;

  private final Clock clock;
  private final Building building;
  private final Whereabouts whereabouts;
  private final Faults faults;
  private final Batteries batteries;
  private final Lighting lighting;
  private final Looks looks;
  private final Containers containers;
  private final Stations stations;
  private final SignalMap signal;
  private final Climate climate;
  private final Talk talk;
  private final boolean shutters;
  private final PersonData persons;
  private final List<WorldEvent.Listener> listeners = new CopyOnWriteArrayList<>();
  private volatile boolean ended;

  public World(Home home, Scene scene, Clock clock, long seed, PhysicalParameters parameters) {
    this.clock = clock;
    this.building = new Building(home, scene);
    this.whereabouts = new Whereabouts(this, clock);
    this.faults = new Faults(this, clock);
    this.batteries = new Batteries(this, clock, whereabouts);
    this.lighting =
        new Lighting(
            this, clock, home, scene, building, seed, parameters.shutters(), faults::isAlive);
    this.looks = new Looks(home, scene);
    this.containers = new Containers(home);
    this.stations = new Stations(home, scene);
    this.signal = SignalMap.drawn(building.map().areas(), seed, parameters.signal());
    this.climate = new Climate(this, clock, scene, parameters.climate(), faults::isAlive);
    listen(event -> climate.happened(event.subject()));
    this.talk = new Talk(this, clock);
    this.shutters = parameters.shutters();
    this.persons = parameters.person();
    home.individuals().keySet().forEach(name -> begin(name, scene.of(name)));
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
    entry.ambientLux().ifPresent(lux -> lighting.setAmbient(name, lux));
    entry.diesWhen().ifPresent(kind -> faults.when(name, kind, () -> die(name)));
    if (entry.dead()) {
      faults.die(name);
    }
  }

  // What is where

  /** Where a thing is, a held one where its holder is; empty when it is nowhere in this world. */
  public Optional<Position> position(String name) {
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
  public Optional<String> holder(String thing) {
    return whereabouts.find(thing).flatMap(Body::holder);
  }

  /** Of the circle around it on the floor; metres. */
  public double radius(String name) {
    return whereabouts.body(name).radius();
  }

  /** The colour of its surface. */
  public Paint paint(String name) {
    return looks().paint(name);
  }

  /** Whether it is in a cupboard. */
  public boolean isHidden(String thing) {
    return whereabouts.body(thing).hidden();
  }

  /** What it holds. */
  public Optional<String> held(String robot) {
    return whereabouts.held(robot);
  }

  /** The zone (of a home without zones: the room) in which it is. */
  public Optional<String> zone(String name) {
    return position(name).flatMap(place -> building.map().areaAt(place.floor())).map(Area::name);
  }

  /** Where a robot went, corner by corner, up to now. */
  public List<PathPoint> path(String robot) {
    return whereabouts.path(robot);
  }

  /** Names of all that is in the world, robots too. */
  public Set<String> bodies() {
    return whereabouts.names();
  }

  // Light

  /** Light on a horizontal surface; lux. */
  public double lux(Position point) {
    return lighting.lux(point);
  }

  /**
   * Light at a zone's reference point; lux.
   *
   * @throws SimulationException when there is no such zone
   */
  public double lux(String zone) {
    return lux(Position.onFloor(building.map().area(zone).reference()));
  }

  /** 0 when the lamp has no power. */
  public synchronized double lampLevel(String lamp) {
    return isAlive(lamp) ? lighting.lamp(lamp).level() : 0;
  }

  /**
   * @throws SimulationException when there is no such zone
   */
  public void setAmbient(String zone, double lux) {
    lighting.setAmbient(building.map().area(zone).name(), lux);
  }

  /** Whether the shutters that the home names hang before their windows. */
  public boolean hasShutters() {
    return shutters;
  }

  /** The share of its windows that a shutter leaves free, 0 to 1. */
  public double opening(String shutter) {
    return lighting.opening(shutter);
  }

  /** What would come in by windows to a point of a room, with all shutters open; lux. */
  public double daylightWithOpenShutters(Position point) {
    return lighting.daylightWithOpenShutters(point);
  }

  /** From now on clouds hide so much of the sky, all the time; 0 to 1. */
  public void setClouds(double cover) {
    lighting.cloud(Clouds.steady(cover));
  }

  /**
   * A lamp now gives another share of its stated light.
   *
   * @param strength 1 is all
   */
  public synchronized void weaken(String lamp, double strength) {
    lighting.put(lamp, lighting.lamp(lamp).weakened(strength));
  }

  // Warmth

  /**
   * How warm the air of a zone is; degrees Celsius.
   *
   * @throws SimulationException when there is no such zone
   */
  public double celsius(String zone) {
    return climate.celsius(building.map().area(zone).name());
  }

  // Changes by hand

  /** Puts a thing or person somewhere, out of whatever hand it is in. */
  public void moveByHand(String thing, Position place) {
    Optional<String> holder;
    synchronized (this) {
      holder = holder(thing);
      whereabouts.stop(thing);
      whereabouts.put(whereabouts.body(thing).at(place));
    }
    tell(WorldEvent.Kind.MOVED, thing, Optional.empty());
    // A hand feels that it is empty.
    holder.ifPresent(robot -> tell(WorldEvent.Kind.DROPPED, robot, Optional.of(thing)));
  }

  /** A person takes a thing that is neither in a cupboard nor in a hand. */
  public void takeByHand(String person, String thing) {
    boolean taken;
    synchronized (this) {
      Body body = whereabouts.body(thing);
      taken = body.isInTheOpen();
      if (taken) {
        whereabouts.put(body.heldBy(person));
      }
    }
    if (taken) {
      tell(WorldEvent.Kind.PICKED, person, Optional.of(thing));
    }
  }

  /** A person puts what she holds on the floor beside her. */
  public void putDownByHand(String person) {
    letGo(person, WorldEvent.Kind.PLACED);
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
      building.setDoor(door, open);
      lighting.changed();
    }
    tell(open ? WorldEvent.Kind.OPENED : WorldEvent.Kind.CLOSED, door, Optional.empty());
  }

  public boolean isOpen(String door) {
    return building.isOpen(door);
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
      lighting.changed();
    }
    drop(device);
    tell(WorldEvent.Kind.DIED, device, Optional.empty());
  }

  /** What the robot holds falls to the floor beside it. */
  public void drop(String robot) {
    letGo(robot, WorldEvent.Kind.DROPPED);
  }

  private void letGo(String holder, WorldEvent.Kind kind) {
    Optional<String> thing;
    synchronized (this) {
      thing = held(holder);
      thing.ifPresent(held -> whereabouts.put(whereabouts.body(held).at(landingSpot(holder))));
    }
    thing.ifPresent(held -> tell(kind, holder, Optional.of(held)));
  }

  private Position landingSpot(String robot) {
    return LandingSpot.beside(
        position(robot).orElseThrow().floor(),
        radius(robot),
        whereabouts.obstacles(robot),
        building.map(),
        building.plan());
  }

  /** Commands to the device take effect after so many seconds only. */
  public void freeze(String device, double seconds) {
    faults.freeze(device, seconds);
  }

  /**
   * From now on what a sensor measures is so many times the truth, and by a share more every hour.
   *
   * @param factor 1 is the truth
   */
  public void distort(String sensor, double factor, double sharePerHour) {
    faults.distort(sensor, factor, sharePerHour);
  }

  /** From now on the device is broken without saying so. */
  public void flaw(String device, Flaw flaw) {
    faults.flaw(device, flaw);
  }

  /**
   * From now on the robot's wheels lose a share of their way.
   *
   * @param share 0 to 1
   */
  public void slip(String robot, double share) {
    faults.slip(robot, share);
  }

  /** What is left in a robot's battery, 0 to 1; 1 when it has none. */
  public double charge(String robot) {
    return batteries.charge(robot);
  }

  /**
   * Charges or drains a battery at once. A robot without power still has to be revived.
   *
   * @param share 0 to 1
   */
  public void charge(String robot, double share) {
    batteries.charge(robot, share);
  }

  /** All lamps over a zone lose their power, and no other light is left there but the day's. */
  public void darken(String zone) {
    Area area = building.map().area(zone);
    lighting.setAmbient(zone, 0);
    lighting.lampsOver(area).forEach(this::die);
  }

  /** The device has power again; a lamp then is off. */
  public void revive(String device) {
    synchronized (this) {
      if (!faults.revive(device)) {
        return;
      }
      if (lighting.hasLamp(device)) {
        lighting.setLevel(device, 0);
      }
    }
    tell(WorldEvent.Kind.REVIVED, device, Optional.empty());
  }

  public boolean isAlive(String device) {
    return faults.isAlive(device);
  }

  /** From now on every command to the device fails, until {@link #repair}. */
  public void breakDown(String device, String reason) {
    faults.breakDown(device, reason);
  }

  public void repair(String device) {
    faults.repair(device);
  }

  /**
   * Runs the action once, the next time that this happens to the device; a command so met by {@link
   * #die} has no effect.
   */
  public void when(String device, WorldEvent.Kind kind, Runnable action) {
    faults.when(device, kind, action);
  }

  /** Tells the listener of everything from now on. */
  public void listen(WorldEvent.Listener listener) {
    listeners.add(listener);
  }

  public void tell(WorldEvent.Kind kind, String subject, Optional<String> thing) {
    List<Runnable> due = faults.triggered(subject, kind);
    WorldEvent event = new WorldEvent(clock.now(), kind, subject, thing);
    listeners.forEach(listener -> listener.happened(event));
    due.forEach(Runnable::run);
  }

  // Its parts, for drivers

  public Building building() {
    return building;
  }

  public Whereabouts whereabouts() {
    return whereabouts;
  }

  public Lighting lighting() {
    return lighting;
  }

  public Faults faults() {
    return faults;
  }

  public Batteries batteries() {
    return batteries;
  }

  /** Whether the robot stands where its battery can be charged. */
  public boolean isAtStation(String robot) {
    return stations.isAt(position(robot).orElseThrow().floor());
  }

  /** The signal over the floor, of homes in which somebody asks for it. */
  public SignalMap signal() {
    return signal;
  }

  public Climate climate() {
    return climate;
  }

  public Talk talk() {
    return talk;
  }

  public PersonData persons() {
    return persons;
  }

  public Containers containers() {
    return containers;
  }

  public Looks looks() {
    return looks;
  }

  public Duration now() {
    return clock.now();
  }

  /** Runs something so many seconds later, on the clock's thread, unless the world has ended. */
  public void later(String subject, double seconds, Runnable action) {
    clock.schedule(
        Duration.ofNanos(Math.round(seconds * NANOS)),
        subject,
        () -> {
          if (!ended) {
            action.run();
          }
        });
  }

  /** Nothing goes on by itself from now on. */
  public void end() {
    ended = true;
  }
}
