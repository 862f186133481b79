package org.maestro.console.states;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.maestro.agents.pulse.Condition;

/**
 * The containers of other processes that were there and are not any more: JADE forgets them at
 * once, and the platform may have one of its own under the name a moment later. Each is kept until
 * another process has the name, and for a while at most. For one thread at a time.
 */
final class GoneContainers {
  static final Duration KEPT = Duration.ofMinutes(10);
  private static final int MOST = 100;

  private final InstantSource wall;
  private final Map<String, Kept> there = new TreeMap<>();
  private final Map<String, Kept> gone = new TreeMap<>();

  /** A container as it was seen last. */
  private record Kept(Observed.Container container, Instant lastSign) {}

  GoneContainers(InstantSource wall) {
    this.wall = wall;
  }

  /** Those that are gone, when these are there. */
  List<Observed.Container> without(List<Observed.Container> now) {
    Instant instant = wall.instant();
    Map<String, Kept> before = new TreeMap<>(there);
    there.clear();
    now.stream()
        .filter(container -> !container.isOwn())
        .forEach(
            container -> {
              there.put(container.name(), new Kept(container, instant.minus(container.silence())));
              before.remove(container.name());
              gone.remove(container.name());
            });
    gone.putAll(before);
    gone.values().removeIf(kept -> kept.lastSign().isBefore(instant.minus(KEPT)));
    while (gone.size() > MOST) {
      gone.remove(gone.keySet().iterator().next());
    }
    List<Observed.Container> told = new ArrayList<>();
    gone.values().forEach(kept -> told.add(asGone(kept, instant)));
    return told;
  }

  private static Observed.Container asGone(Kept kept, Instant now) {
    Observed.Container last = kept.container();
    return new Observed.Container(
        last.name(),
        last.process(),
        false,
        Condition.LOST,
        Duration.between(kept.lastSign(), now),
        last.agents());
  }
}
