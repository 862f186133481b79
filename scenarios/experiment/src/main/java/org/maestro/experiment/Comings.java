package org.maestro.experiment;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import org.maestro.experiment.running.TrialSite;

/**
 * The events of members that come, go and fail while a goal is pursued; drawn from a seed, before
 * anything is known of how the goal is pursued.
 */
record Comings(List<Coming> events) {
  private static final int LATEST_MILLIS = 12_000;
  private static final double OFTEN = 0.5;
  private static final double LESS_OFTEN = 0.4;

  /** The kind of an event. */
  enum Kind {
    /** Its power fails: it lets go of what it holds and vanishes. */
    FAILS,
    /** It has power again, and joins anew. */
    JOINS,
    /** It goes from the bus, and works on by itself. */
    LEAVES,
    /** It is back on the bus. */
    RETURNS
  }

  record Coming(long atMillis, String member, Kind kind) {
    String text() {
      return String.format(
          Locale.ROOT,
          "%s %s at %.1f s",
          member,
          kind.name().toLowerCase(Locale.ROOT),
          atMillis / 1e3);
    }
  }

  Comings {
    events = List.copyOf(events);
  }

  /**
   * @param robots of which the last is away at first, half of the time, and comes while the goal is
   *     pursued
   */
  static Comings drawn(long seed, List<String> robots, List<String> others) {
    SplittableRandom random = new SplittableRandom(seed);
    List<Coming> events = new ArrayList<>();
    String late = robots.get(robots.size() - 1);
    if (random.nextDouble() < OFTEN) {
      events.add(new Coming(0, late, Kind.FAILS));
      events.add(new Coming(time(random), late, Kind.JOINS));
    }
    int count = 1 + random.nextInt(3);
    for (int i = 0; i < count; i++) {
      List<String> among = random.nextDouble() < OFTEN ? robots : others;
      String member = among.get(random.nextInt(among.size()));
      boolean fails = random.nextDouble() < OFTEN;
      long at = time(random);
      events.add(new Coming(at, member, fails ? Kind.FAILS : Kind.LEAVES));
      if (random.nextDouble() < LESS_OFTEN) {
        events.add(new Coming(at + time(random), member, fails ? Kind.JOINS : Kind.RETURNS));
      }
    }
    events.sort(Comparator.comparingLong(Coming::atMillis));
    return new Comings(events);
  }

  private static long time(SplittableRandom random) {
    return random.nextInt(LATEST_MILLIS);
  }

  /** From now on they happen, each in its time. */
  void schedule(TrialSite site) {
    for (Coming event : events) {
      site.clock()
          .schedule(Duration.ofMillis(event.atMillis()), "comings", () -> happen(event, site));
    }
  }

  private static void happen(Coming event, TrialSite site) {
    switch (event.kind()) {
      case FAILS -> site.world().die(event.member());
      case JOINS -> site.world().revive(event.member());
      case LEAVES -> site.cut(event.member());
      case RETURNS -> site.mend(event.member());
    }
  }

  String text() {
    return String.join("; ", events.stream().map(Coming::text).toList());
  }
}
