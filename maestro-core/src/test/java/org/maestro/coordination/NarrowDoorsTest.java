package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.contention.ResourceClaimsTest;
import org.maestro.fixtures.Share;
import org.maestro.ontology.home.Home;

/**
 * Seeded runs of three robots and two narrow doors with several wishes at once: every wish comes to
 * an end, and no two robots get into each other's way.
 */
class NarrowDoorsTest {
  private static final List<String> ROBOTS = List.of("rose", "tim", "una");
  private static final List<String> ITEMS = List.of("Cup", "Mug", "Jar", "Tin", "Box");
  private static final List<String> ZONES = List.of("zone-a", "zone-b", "zone-c");

  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    home = ResourceClaimsTest.narrowHome();
  }

  @Test
  void noneOfSomeRunsEndsInADeadlock() {
    check(LongStream.range(0, 30));
  }

  @Test
  @Tag("full")
  void noneOfAThousandRunsEndsInADeadlock() {
    check(Share.of(LongStream.range(0, 1000)));
  }

  private static void check(LongStream seeds) {
    List<String> bad = new ArrayList<>();
    seeds.forEach(seed -> problem(seed).ifPresent(text -> bad.add("seed " + seed + ": " + text)));
    assertThat(bad).isEmpty();
  }

  private static Optional<String> problem(long seed) {
    Random random = new Random(seed);
    NarrowHouse house = new NarrowHouse(home, seed);
    ROBOTS.forEach(robot -> house.with(robot, pick(ZONES, random)));
    ITEMS.forEach(item -> house.with(item, pick(ZONES, random)));
    house.failures = random.nextInt(3) == 0 ? 0.1 : 0;
    boolean dies = random.nextInt(5) == 0;
    int wishes = 3 + random.nextInt(4);
    for (int i = 0; i < wishes; i++) {
      String goal = goal(random);
      int priority = random.nextInt(4) == 0 ? 1 + random.nextInt(2) : 0;
      Duration at = Duration.ofMillis(random.nextInt(20_000));
      Optional<Duration> deadline =
          random.nextInt(6) == 0
              ? Optional.of(at.plusSeconds(10 + random.nextInt(200)))
              : Optional.empty();
      house.clock.schedule(at, "us", () -> house.wish(goal, priority, deadline));
    }
    if (dies) {
      house.clock.schedule(
          Duration.ofMillis(5_000 + random.nextInt(20_000)),
          "us",
          () -> house.die(pick(ROBOTS, random)));
    }
    boolean ended;
    try {
      ended = house.run(wishes, Duration.ofMinutes(20));
    } catch (IllegalStateException e) {
      return Optional.of(e.getMessage());
    }
    if (!ended) {
      return Optional.of("not all ended: " + house.coordinator.goals() + "\n" + house.told());
    }
    if (!house.accidents.isEmpty()) {
      return Optional.of("accidents: " + house.accidents);
    }
    if (!house.coordinator.waits().isEmpty()) {
      return Optional.of("somebody still waits: " + house.coordinator.waits());
    }
    return house.outcomes.values().stream()
        .filter(outcome -> !outcome.reached() && !isExcused(outcome, dies))
        .findFirst()
        .map(outcome -> "not reached: " + outcome + "\n" + house.told());
  }

  /** With all robots alive only a deadline is an excuse, and what goes wrong again and again. */
  private static boolean isExcused(GoalOutcome outcome, boolean dies) {
    return dies
        || outcome.reasons().get(0).contains("deadline")
        || outcome.reasons().get(0).contains("times with the same facts");
  }

  private static String goal(Random random) {
    String one = "(in %s %s)".formatted(pick(ITEMS, random), pick(ZONES, random));
    if (random.nextInt(4) > 0) {
      return one;
    }
    String first = pick(ITEMS, random);
    String second = pick(ITEMS.stream().filter(item -> !item.equals(first)).toList(), random);
    return "(and (in %s %s) (in %s %s))"
        .formatted(first, pick(ZONES, random), second, pick(ZONES, random));
  }

  private static <T> T pick(List<T> all, Random random) {
    return all.get(random.nextInt(all.size()));
  }
}
