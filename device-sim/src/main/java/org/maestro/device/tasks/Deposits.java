package org.maestro.device.tasks;

import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.hal.Position;

/**
 * The places where a robot has put things down, as it remembers: for callers that know only in
 * which area a thing is. What it picks up again is there no more; what others carry off it does not
 * notice. Clock thread only.
 */
public final class Deposits {
  private final Map<String, Position> places = new TreeMap<>();

  void put(String thing, Position place) {
    places.put(thing, place);
  }

  void forget(String thing) {
    places.remove(thing);
  }

  /** Where the thing is: what the caller knows counts, and else what the robot remembers. */
  Optional<Position> position(Pointer thing) {
    return thing.position().or(() -> Optional.ofNullable(places.get(thing.name())));
  }
}
