package org.maestro.random;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.hal.Position;
import org.maestro.sim.world.World;

/**
 * The truth of one moment.
 *
 * @param places of all bodies; a held one is where its holder is
 * @param luxByThing light where each body is
 * @param levels of lamps, and how far shutters are open
 * @param daylight at all places of which the light is judged
 * @param luxByLocation light at the reference point of each zone and desk
 */
record Moment(
    Duration at,
    Map<String, Position> places,
    Map<String, String> zones,
    Map<String, String> holders,
    Set<String> hidden,
    Set<String> openDoors,
    Set<String> alive,
    Map<String, Double> luxByThing,
    Map<String, Double> luxByLocation,
    Map<String, Double> levels,
    Map<Position, Double> daylight) {

  static Moment of(World world, Site site, Duration at) {
    Map<String, Position> places = new TreeMap<>();
    Map<String, String> zones = new TreeMap<>();
    Map<String, String> holders = new TreeMap<>();
    Set<String> hidden = new TreeSet<>();
    Map<String, Double> luxByThing = new TreeMap<>();
    for (String name : world.bodies()) {
      Position place = world.position(name).orElseThrow();
      places.put(name, place);
      world.zone(name).ifPresent(zone -> zones.put(name, zone));
      world.holder(name).ifPresent(holder -> holders.put(name, holder));
      if (world.isHidden(name)) {
        hidden.add(name);
      }
      luxByThing.put(name, world.lux(place));
    }
    Map<String, Double> luxByLocation = new TreeMap<>();
    site.floor().locations().forEach((name, place) -> luxByLocation.put(name, world.lux(place)));
    Set<String> openDoors = new TreeSet<>(site.floor().doors());
    openDoors.removeIf(door -> !world.isOpen(door));
    Set<String> alive = new TreeSet<>(site.devices());
    alive.removeIf(device -> !world.isAlive(device));
    Map<String, Double> levels = new TreeMap<>();
    site.lamps().forEach(lamp -> levels.put(lamp, world.lampLevel(lamp)));
    Map<Position, Double> daylight = new HashMap<>();
    if (!site.shutters().isEmpty()) {
      site.shutters().forEach(shutter -> levels.put(shutter, world.opening(shutter)));
      site.floor()
          .litPlaces()
          .forEach(place -> daylight.put(place, world.daylightWithOpenShutters(place)));
    }
    return new Moment(
        at,
        places,
        zones,
        holders,
        hidden,
        openDoors,
        alive,
        luxByThing,
        luxByLocation,
        levels,
        daylight);
  }

  /** All that is asked for was looked at in that moment. */
  private static <K, V> V noted(Map<K, V> values, K of) {
    return Objects.requireNonNull(values.get(of));
  }

  Position place(String thing) {
    return noted(places, thing);
  }

  Optional<String> zone(String thing) {
    return Optional.ofNullable(zones.get(thing));
  }

  Optional<String> holder(String thing) {
    return Optional.ofNullable(holders.get(thing));
  }

  boolean isHidden(String thing) {
    return hidden.contains(thing);
  }

  boolean isAlive(String device) {
    return alive.contains(device);
  }

  /** What comes in there by the window, its shutter open. */
  double daylight(Position place) {
    return noted(daylight, place);
  }

  double lux(String thing) {
    return noted(luxByThing, thing);
  }

  /** Of a lamp or a shutter. */
  double level(String device) {
    return noted(levels, device);
  }

  double light(String location) {
    return noted(luxByLocation, location);
  }
}
