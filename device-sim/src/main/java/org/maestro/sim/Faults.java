package org.maestro.sim;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * Which devices have no power or are defect, and what is to happen upon events. Guarded by the
 * world's lock.
 */
final class Faults {

  private final Set<String> dead = new TreeSet<>();
  private final Map<String, String> defects = new TreeMap<>();
  private final Map<String, Map<WorldEvent.Kind, List<Runnable>>> triggers = new TreeMap<>();

  /** Whether it had power until now. */
  boolean die(String device) {
    return dead.add(device);
  }

  /** Whether it had no power until now. */
  boolean revive(String device) {
    return dead.remove(device);
  }

  boolean isAlive(String device) {
    return !dead.contains(device);
  }

  void breakDown(String device, String reason) {
    defects.put(device, reason);
  }

  void repair(String device) {
    defects.remove(device);
  }

  Optional<String> defect(String device) {
    return Optional.ofNullable(defects.get(device));
  }

  void when(String device, WorldEvent.Kind kind, Runnable action) {
    triggers
        .computeIfAbsent(device, name -> new EnumMap<>(WorldEvent.Kind.class))
        .computeIfAbsent(kind, any -> new ArrayList<>())
        .add(action);
  }

  /** What is to happen now; it is forgotten thereby. */
  List<Runnable> triggered(String device, WorldEvent.Kind kind) {
    Map<WorldEvent.Kind, List<Runnable>> ofDevice = triggers.get(device);
    return ofDevice != null && ofDevice.containsKey(kind) ? ofDevice.remove(kind) : List.of();
  }
}
