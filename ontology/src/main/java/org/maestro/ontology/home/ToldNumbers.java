package org.maestro.ontology.home;

import java.util.Set;
import java.util.TreeSet;
import org.maestro.sl.Effect;

/**
 * Numbers that somebody may tell or change, whatever a home states: measured, computed of places,
 * changed by a feature, reported by a device. Immutable.
 */
final class ToldNumbers {
  private final Home home;
  private final Set<String> changed = new TreeSet<>();

  ToldNumbers(Home home) {
    this.home = home;
    for (Device device : home.devices().values()) {
      device.features().forEach(feature -> collect(feature.effect()));
    }
  }

  private void collect(Effect effect) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(this::collect);
    } else if (effect instanceof Effect.When when) {
      collect(when.effect());
    } else if (effect instanceof Effect.Forall forall) {
      collect(forall.effect());
    } else if (effect instanceof Effect.Change change) {
      changed.add(change.fluent().name());
    } else if (effect instanceof Effect.SenseNumber sense) {
      changed.add(sense.fluent().name());
    }
  }

  /** Whether anybody may tell it of things, devices or places. */
  boolean isTold(String name) {
    return isOfAnybody(name)
        || home.devices().values().stream().anyMatch(device -> device.tells(name));
  }

  /** Whether anybody may tell it of this device. */
  boolean isToldOf(Device device, String name) {
    return isOfAnybody(name) || device.tells(name);
  }

  private boolean isOfAnybody(String name) {
    return changed.contains(name)
        || home.vocabulary()
            .predicate(name)
            .filter(declared -> declared.observable() || declared.computedBy().isPresent())
            .isPresent();
  }
}
