package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.LongStream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.contention.ResourceClaimsTest;
import org.maestro.fixtures.Share;
import org.maestro.members.ComponentArbiter;
import org.maestro.ontology.home.Home;

/** Several managers of goals over the same robots (ADE, 6; A94). */
class SeveralManagersTest {
  private static final List<String> ROBOTS = List.of("rose", "tim");
  private static final List<String> MANAGERS = List.of("house", "kitchen", "garden");
  private static final List<String> ITEMS = List.of("Cup", "Mug", "Jar", "Tin", "Box");
  private static final List<String> ZONES = List.of("zone-a", "zone-b", "zone-c");

  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    home = ResourceClaimsTest.narrowHome();
  }

  /** A house with some managers, and an arbiter for each robot. */
  private static final class Site {
    private static final Duration DEATH_IS_SEEN = Duration.ofSeconds(5);

    private final NarrowHouse house;
    private final Map<String, ComponentArbiter> arbiters = new TreeMap<>();
    private final Map<String, GoalManager> managers = new LinkedHashMap<>();

    Site(long seed, List<String> robots) {
      house = new NarrowHouse(home, seed);
      for (String robot : robots) {
        arbiters.put(robot, new ComponentArbiter(new Ways(robot)));
      }
    }

    GoalManager manager(String name) {
      GoalManager manager = new GoalManager(name, house, arbiters);
      managers.put(name, manager);
      return manager;
    }

    /** Its death is seen by who has something to tell it, some time later. */
    void kill(GoalManager manager) {
      manager.die();
      house.clock.schedule(
          DEATH_IS_SEEN, "us", () -> arbiters.values().forEach(a -> a.gone(manager.name)));
    }

    boolean run(int wishes, Duration limit) {
      house.clock.runUntil(() -> ended() == wishes, limit);
      return ended() == wishes;
    }

    private int ended() {
      return managers.values().stream().mapToInt(manager -> manager.outcomes.size()).sum();
    }

    List<GoalOutcome> outcomes() {
      return managers.values().stream()
          .flatMap(manager -> manager.outcomes.values().stream())
          .toList();
    }

    /** The managers do not know of each other's doors. */
    List<String> heldTwice() {
      return house.accidents.stream()
          .filter(text -> ROBOTS.stream().anyMatch(robot -> text.contains("needs " + robot)))
          .toList();
    }

    private final class Ways implements ComponentArbiter.Managers {
      private final String robot;

      Ways(String robot) {
        this.robot = robot;
      }

      @Override
      public void askToYield(String holder, String by, ComponentWant want) {
        managers.get(holder).askedToYield(want);
      }

      @Override
      public void wantedNoMore(String holder, String goalId) {
        managers.get(holder).wantedNoMore(goalId, robot);
      }

      @Override
      public void got(String manager, Set<String> components) {
        managers.get(manager).got(robot, components);
      }
    }
  }

  private static Site oneRobot() {
    Site site = new Site(1, List.of("rose"));
    site.house.with("rose", "zone-a").with("Cup", "zone-a").with("Mug", "zone-a");
    return site;
  }

  @Test
  void theSecondManagerWaitsForTheGripperAndSaysWhoHasIt() {
    Site site = oneRobot();
    GoalManager kitchen = site.manager("kitchen");
    GoalManager garden = site.manager("garden");
    kitchen.wish("(in Cup zone-b)", 0);
    site.house.clock.run(Duration.ofMillis(500));
    String second = garden.wish("(in Mug zone-b)", 0);
    site.house.clock.run(Duration.ofSeconds(3));

    assertThat(garden.status(second).state()).as(site.house.told()).isEqualTo(GoalState.WAITING);
    assertThat(garden.status(second).detail()).contains("rose").contains("kitchen-1");
    assertThat(site.run(2, Duration.ofMinutes(5))).as(site.house.told()).isTrue();
    assertThat(site.outcomes()).allMatch(GoalOutcome::reached);
    assertThat(site.heldTwice()).isEmpty();
    assertThat(site.house.calls).filteredOn(call -> call.startsWith("pick")).hasSize(2);
  }

  @Test
  void theHigherGoalOfAnotherManagerGetsTheRobotAtASafePointAndTheOtherGoesOnAfterwards() {
    Site site = oneRobot();
    site.house.with("Cup", "zone-c");
    GoalManager kitchen = site.manager("kitchen");
    GoalManager house = site.manager("house");
    String low = kitchen.wish("(in Cup zone-b)", 0);
    site.house.clock.run(Duration.ofSeconds(1));
    house.wish("(in Mug zone-b)", 5);
    site.house.clock.run(Duration.ofSeconds(9));

    assertThat(kitchen.status(low).state()).as(site.house.told()).isEqualTo(GoalState.SUSPENDED);
    assertThat(kitchen.status(low).detail()).contains("house-1").contains("rose");
    assertThat(site.run(2, Duration.ofMinutes(5))).as(site.house.told()).isTrue();
    assertThat(site.outcomes()).allMatch(GoalOutcome::reached);
    assertThat(site.heldTwice()).isEmpty();
  }

  @Test
  void whatADeadManagerHadOthersGetAndWhatItWantedGoesOnWhenItIsBack() {
    Site site = oneRobot();
    GoalManager kitchen = site.manager("kitchen");
    GoalManager garden = site.manager("garden");
    kitchen.wish("(in Cup zone-c)", 0);
    site.house.clock.runUntil(
        () -> "rose".equals(site.house.place.get("Cup")), Duration.ofMinutes(1));
    garden.wish("(in Mug zone-b)", 0);
    site.house.clock.run(Duration.ofSeconds(1));
    site.kill(kitchen);
    assertThat(site.run(1, Duration.ofMinutes(5))).as(site.house.told()).isTrue();
    assertThat(garden.outcomes.values()).allMatch(GoalOutcome::reached);

    kitchen.live();
    assertThat(site.run(2, Duration.ofMinutes(5))).as(site.house.told()).isTrue();
    assertThat(kitchen.outcomes.values()).as(site.house.told()).allMatch(GoalOutcome::reached);
    assertThat(site.heldTwice()).isEmpty();
  }

  @Test
  void noneOfSomeRunsEndsInADeadlock() {
    check(LongStream.range(0, 50));
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
    Site site = new Site(seed, ROBOTS);
    ROBOTS.forEach(robot -> site.house.with(robot, pick(ZONES, random)));
    ITEMS.forEach(item -> site.house.with(item, pick(ZONES, random)));
    MANAGERS.forEach(site::manager);
    int wishes = 4 + random.nextInt(5);
    for (int i = 0; i < wishes; i++) {
      GoalManager manager = site.managers.get(pick(MANAGERS, random));
      String goal = goal(random);
      int priority = random.nextInt(3) == 0 ? 1 + random.nextInt(2) : 0;
      site.house.clock.schedule(
          Duration.ofMillis(random.nextInt(20_000)),
          "us",
          () -> wish(site, manager, goal, priority));
    }
    if (random.nextInt(2) == 0) {
      GoalManager victim = site.managers.get(pick(MANAGERS, random));
      Duration death = Duration.ofMillis(3_000 + random.nextInt(30_000));
      site.house.clock.schedule(death, "us", () -> site.kill(victim));
      site.house.clock.schedule(death.plusMillis(500 + random.nextInt(30_000)), "us", victim::live);
    }
    boolean ended;
    try {
      ended = site.run(wishes, Duration.ofMinutes(20));
    } catch (IllegalStateException e) {
      return Optional.of(String.valueOf(e.getMessage()));
    }
    if (!ended) {
      return Optional.of(
          "not all ended: %s\n%s\n%s".formatted(goals(site), waits(site), site.house.told()));
    }
    if (!site.heldTwice().isEmpty()) {
      return Optional.of("held twice: " + site.heldTwice() + "\n" + site.house.told());
    }
    return site.outcomes().stream()
        .filter(outcome -> !outcome.reached())
        .findFirst()
        .map(outcome -> "not reached: " + outcome + "\n" + site.house.told());
  }

  /** Who wishes of a manager that is dead asks again later. */
  private static void wish(Site site, GoalManager manager, String goal, int priority) {
    if (manager.isAlive()) {
      manager.wish(goal, priority);
    } else {
      site.house.clock.schedule(
          Duration.ofSeconds(1), "us", () -> wish(site, manager, goal, priority));
    }
  }

  private static List<String> goals(Site site) {
    return site.managers.values().stream()
        .flatMap(manager -> manager.goals().stream())
        .map(String::valueOf)
        .toList();
  }

  private static List<String> waits(Site site) {
    return site.managers.values().stream()
        .map(manager -> manager.name + " " + manager.waits())
        .toList();
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
