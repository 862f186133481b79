package org.maestro.coordination.contention;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.NarrowHouse;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** Several goals at once over three robots and two narrow doors. */
public class ResourceClaimsTest {
  static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    home = narrowHome();
  }

  public static Home narrowHome() throws IOException {
    try (InputStream turtle = ResourceClaimsTest.class.getResourceAsStream("/narrow.ttl")) {
      return new HomeLoader()
          .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "narrow.ttl");
    }
  }

  private NarrowHouse house(String... robots) {
    NarrowHouse house = new NarrowHouse(home, 1);
    for (String robot : home.devices().keySet()) {
      if (!java.util.List.of(robots).contains(robot)) {
        house.coordinator.memberLost(robot, "not in this test");
      }
    }
    return house;
  }

  @Test
  void twoGoalsWithTwoRobotsRunAtTheSameTime() {
    NarrowHouse house = house("rose", "tim");
    house.with("rose", "zone-a").with("tim", "zone-c").with("Cup", "zone-a").with("Mug", "zone-c");
    house.wish("(in Cup zone-b)");
    house.wish("(in Mug zone-b)");

    assertThat(house.run(2, Duration.ofSeconds(25))).as(house.told()).isTrue();
    assertThat(house.accidents).isEmpty();
    assertThat(house.outcomes.values()).allMatch(GoalOutcome::reached);
  }

  @Test
  void theSecondWaitsForTheOnlyRobotAndSaysSo() {
    NarrowHouse house = house("rose");
    house.with("rose", "zone-a").with("Cup", "zone-a").with("Mug", "zone-a");
    String first = house.wish("(in Cup zone-b)");
    String second = house.wish("(in Mug zone-b)");
    house.clock.run(Duration.ofSeconds(4));

    assertThat(house.state(first)).isEqualTo(GoalState.RUNNING);
    assertThat(house.state(second)).as(house.told()).isEqualTo(GoalState.WAITING);
    assertThat(house.status(second).detail()).contains("base of rose").contains(first);
    assertThat(house.coordinator.waits())
        .contains(new WaitsFor(second, Resource.component("rose", "base"), first));

    assertThat(house.run(2, Duration.ofMinutes(5))).as(house.told()).isTrue();
    assertThat(house.outcomes.values()).allMatch(GoalOutcome::reached);
    assertThat(house.coordinator.waits()).isEmpty();
    assertThat(house.calls).filteredOn(c -> c.startsWith("pick")).hasSize(2);
  }

  @Test
  void aFreeRobotFartherAwayIsTakenWhenWaitingWouldTakeLonger() {
    NarrowHouse house = house("rose", "una");
    house.with("rose", "zone-a").with("una", "zone-c").with("Cup", "zone-a").with("Mug", "zone-a");
    house.wish("(in Cup zone-c)");
    house.clock.run(Duration.ofMillis(500));
    house.wish("(in Mug zone-b)");

    assertThat(house.run(2, Duration.ofMinutes(5))).as(house.told()).isTrue();
    assertThat(house.calls).contains("pick una");
  }

  @Test
  void whoIsMoreImportantGetsTheRobotAtASafePointAndTheOtherGoesOnAfterwards() {
    NarrowHouse house = house("rose");
    house.with("rose", "zone-a").with("Cup", "zone-c").with("Mug", "zone-a");
    String low = house.wish("(in Cup zone-b)");
    house.clock.run(Duration.ofSeconds(1));
    String high = house.wish("(in Mug zone-b)", 5, Optional.empty());
    house.clock.run(Duration.ofSeconds(8));

    assertThat(house.state(low)).as(house.told()).isEqualTo(GoalState.SUSPENDED);
    assertThat(house.status(low).detail()).contains(high).contains("rose");
    assertThat(house.run(2, Duration.ofMinutes(5))).as(house.told()).isTrue();
    assertThat(house.outcomes.values()).allMatch(GoalOutcome::reached);
    assertThat(house.outcomes.keySet()).containsExactly(high, low);
    assertThat(house.accidents).isEmpty();
  }

  @Test
  void whatIsCarriedForAGoalStaysWithItHoweverImportantAnotherIs() {
    NarrowHouse house = house("rose");
    house.with("rose", "zone-a").with("Cup", "zone-a").with("Mug", "zone-a");
    String low = house.wish("(in Cup zone-c)");
    house.clock.runUntil(() -> "rose".equals(house.place.get("Cup")), Duration.ofMinutes(1));
    String high = house.wish("(in Mug zone-b)", 5, Optional.empty());

    assertThat(house.run(2, Duration.ofMinutes(5))).as(house.told()).isTrue();
    assertThat(house.outcomes.keySet()).containsExactly(low, high);
    assertThat(house.calls).filteredOn(c -> c.startsWith("place")).hasSize(2);
  }

  @Test
  void aGoalWhoseDeadlineHasPassedFailsAndLeavesItsRobotToOthers() {
    NarrowHouse house = house("rose");
    house.with("rose", "zone-a").with("Cup", "zone-a").with("Mug", "zone-a");
    String first = house.wish("(in Cup zone-c)", 0, Optional.of(Duration.ofSeconds(3)));
    String second = house.wish("(in Mug zone-b)");

    assertThat(house.run(2, Duration.ofMinutes(5))).as(house.told()).isTrue();
    assertThat(house.outcomes.get(first).state()).isEqualTo(GoalState.FAILED);
    assertThat(house.outcomes.get(first).reasons().get(0)).contains("deadline");
    assertThat(house.outcomes.get(first).endedAt())
        .isBetween(Duration.ofSeconds(3), Duration.ofMillis(3100));
    assertThat(house.outcomes.get(second).reached()).isTrue();
    assertThat(house.accidents).isEmpty();
  }

  @Test
  void theEarlierDeadlineGoesFirst() {
    NarrowHouse house = house("rose");
    house.with("rose", "zone-a").with("Cup", "zone-a").with("Mug", "zone-a").with("Jar", "zone-a");
    String first = house.wish("(in Cup zone-b)");
    String relaxed = house.wish("(in Mug zone-b)");
    String urgent = house.wish("(in Jar zone-b)", 0, Optional.of(Duration.ofMinutes(4)));

    assertThat(house.run(3, Duration.ofMinutes(5))).as(house.told()).isTrue();
    assertThat(house.outcomes.keySet()).containsExactly(first, urgent, relaxed);
  }

  @Test
  void aDeadRobotLosesTheDoor() {
    NarrowHouse house = house("rose", "tim");
    house.with("rose", "zone-a").with("tim", "zone-a").with("Cup", "zone-b").with("Mug", "zone-b");
    house.wish("(in Cup zone-a)");
    house.clock.runUntil(() -> house.calls.contains("move rose"), Duration.ofMinutes(1));
    house.mute.add("rose");
    house.die("rose");
    house.wish("(in Mug zone-a)");

    assertThat(house.run(2, Duration.ofMinutes(5))).as(house.told()).isTrue();
    assertThat(house.outcomes.values()).as(house.told()).allMatch(GoalOutcome::reached);
  }

  @Test
  void whatOneGoalHasBroughtAboutIsNotUndoneByAnotherBeforeItIsOver() {
    NarrowHouse house = house("rose", "tim");
    house.with("rose", "zone-a").with("tim", "zone-c").with("Cup", "zone-b").with("Mug", "zone-b");
    house.wish("(and (in Cup zone-a) (in Mug zone-a))");
    house.wish("(and (in Cup zone-c) (in Mug zone-c))");

    assertThat(house.run(2, Duration.ofMinutes(10))).as(house.told()).isTrue();
    assertThat(house.outcomes.values()).allMatch(GoalOutcome::reached);
    assertThat(house.accidents).isEmpty();
    assertThat(house.calls).filteredOn(c -> c.startsWith("pick")).hasSizeLessThanOrEqualTo(6);
  }
}
