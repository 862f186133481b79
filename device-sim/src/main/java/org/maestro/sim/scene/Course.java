package org.maestro.sim.scene;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * The events of a scene that happen of their own accord. Immutable.
 *
 * @param faults by the thing, zone or device to which they happen; the empty name is the home
 * @param walks corners of the rounds that persons walk, by name
 * @param roams for how many seconds persons who go about stay in a place in the mean, by name
 * @param sayings what persons say, by name
 */
public record Course(
    Map<String, List<ScriptedFault>> faults,
    Map<String, List<Stop>> walks,
    Map<String, Double> roams,
    Map<String, List<Saying>> sayings) {

  public static final Course NOTHING = new Course(Map.of(), Map.of(), Map.of(), Map.of());

  public Course {
    faults = Collections.unmodifiableMap(new TreeMap<>(faults));
    walks = Collections.unmodifiableMap(new TreeMap<>(walks));
    roams = Collections.unmodifiableMap(new TreeMap<>(roams));
    sayings = Collections.unmodifiableMap(new TreeMap<>(sayings));
  }
}
