package org.maestro.sim.scene;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.maestro.hal.Position;
import org.maestro.hal.sight.Paint;

/**
 * The ground truth with which a simulation begins, by local names of the home. The knowledge base
 * never reads it. Immutable.
 */
public record Scene(
    String name,
    Map<String, Entry> entries,
    Optional<SceneSky> sky,
    Map<String, Double> openings,
    Course course,
    Map<String, List<String>> states) {

  /**
   * @param sky without it no light comes in by windows
   * @param openings how far shutters are open, 0 to 1; others are closed
   * @param course what happens of its own accord
   * @param states what else is so of a thing, facts in MAESTRO-SL
   */
  public Scene {
    entries = Collections.unmodifiableMap(new LinkedHashMap<>(entries));
    openings = Collections.unmodifiableMap(new TreeMap<>(openings));
    states = Collections.unmodifiableMap(new TreeMap<>(states));
  }

  /** A scene without daylight, in which nothing happens of its own accord. */
  public Scene(String name, Map<String, Entry> entries) {
    this(name, entries, Optional.empty(), Map.of(), Course.NOTHING, Map.of());
  }

  /** What else is so of the thing in the beginning, facts in MAESTRO-SL. */
  public List<String> states(String thing) {
    return states.getOrDefault(thing, List.of());
  }

  /** What the scene says of it; nothing when it is not mentioned. */
  public Entry of(String thing) {
    return entries.getOrDefault(thing, Entry.NOTHING);
  }

  /** The same scene with another entry for one thing. */
  public Scene with(String thing, Entry entry) {
    Map<String, Entry> changed = new LinkedHashMap<>(entries);
    changed.put(thing, entry);
    return new Scene(name, changed, sky, openings, course, states);
  }

  /** The same scene under another sky. */
  public Scene with(SceneSky other) {
    return new Scene(name, entries, Optional.of(other), openings, course, states);
  }

  /**
   * The ground truth of one thing, place or device.
   *
   * @param hidden no camera sees it and no robot bumps into it: it is in a cupboard
   * @param radius of the circle around it on the floor; metres
   * @param mass kilograms
   * @param level of a lamp, 0 to 1
   * @param strength what a lamp gives of its stated light, 1 is all
   * @param ambientLux light in a zone that comes from no lamp
   * @param open of a door
   * @param dead without power from the beginning
   * @param speed of a robot that drives at another speed than usual; metres per second
   * @param payload of a robot that lifts another mass than usual; kilograms
   * @param diesWhen the {@link WorldEvent.Kind} upon which it loses power
   * @param colour of what has another colour than the home says
   * @param charge of a robot's battery in the beginning, 0 to 1
   * @param charges batteries of robots that stand at its reference point
   * @param celsius how warm the air of a zone is in the beginning
   */
  public record Entry(
      Optional<Position> position,
      boolean hidden,
      OptionalDouble radius,
      OptionalDouble mass,
      OptionalDouble level,
      OptionalDouble strength,
      OptionalDouble ambientLux,
      Optional<Boolean> open,
      boolean dead,
      OptionalDouble speed,
      OptionalDouble payload,
      Optional<WorldEvent.Kind> diesWhen,
      Optional<Paint> colour,
      OptionalDouble charge,
      boolean charges,
      OptionalDouble celsius) {

    public static final Entry NOTHING =
        new Entry(
            Optional.empty(),
            false,
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            Optional.empty(),
            false,
            OptionalDouble.empty(),
            OptionalDouble.empty(),
            Optional.empty(),
            Optional.empty(),
            OptionalDouble.empty(),
            false,
            OptionalDouble.empty());

    public Entry at(Position place) {
      return changed(Optional.of(place), colour);
    }

    /** Painted over. */
    public Entry in(Paint paint) {
      return changed(position, Optional.of(paint));
    }

    private Entry changed(Optional<Position> place, Optional<Paint> paint) {
      return new Entry(
          place,
          hidden,
          radius,
          mass,
          level,
          strength,
          ambientLux,
          open,
          dead,
          speed,
          payload,
          diesWhen,
          paint,
          charge,
          charges,
          celsius);
    }
  }
}
