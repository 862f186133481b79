package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.Stakes;
import org.maestro.coordination.api.Worth;
import org.maestro.coordination.contention.ResourceClaimsTest;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.sl.SlParser;

/** Goals that are worth something to somebody, beside each other and over one robot. */
class WeighedGoalsTest {
  private static final List<String> BUSY = List.of("Mug", "Jar", "Tin");
  private static final int COMPETITORS = 9;

  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    home = ResourceClaimsTest.narrowHome();
  }

  private final NarrowHouse house =
      new NarrowHouse(home, 1).with("rose", "zone-a").with("Cup", "zone-b");

  @Test
  void theHigherOneGetsTheMotorAtASafePointAndTheOtherGoesOnAfterwards() {
    String low = house.wish(request("(in rose zone-c)", stakes("40")));
    house.clock.run(Duration.ofSeconds(1));
    assertThat(house.calls).containsExactly("move rose");

    String high = house.wish(request("(in Cup zone-a)", stakes("200")));
    house.clock.runUntil(() -> house.state(low) == GoalState.SUSPENDED, Duration.ofMinutes(1));

    assertThat(house.place)
        .as("the step under way was not broken off")
        .containsEntry("rose", "zone-b");
    assertThat(house.run(2, Duration.ofMinutes(5))).as(house.told()).isTrue();
    assertThat(house.outcomes.keySet()).containsExactly(high, low);
    assertThat(house.outcomes.values()).allMatch(GoalOutcome::reached);
    assertThat(house.told())
        .contains(
            low + " WAIT Stands back: " + high + " goes first with the base of rose (its u·g is ")
        .containsPattern(low + " WORTH Worth: u = 0.8·40 − 10 = 22; g = 1; priority u·g = 22 ")
        .containsPattern(low + " WAIT Goes on");
    assertThat(house.accidents).isEmpty();
  }

  @Test
  void withoutAConflictTheyRunAtTheSameTime() {
    house.with("tim", "zone-c").with("Mug", "zone-c");
    String first = house.wish(request("(in Cup zone-a)", stakes("50")));
    String second = house.wish(request("(in Mug zone-b)", stakes("500")));
    house.clock.run(Duration.ofSeconds(1));

    assertThat(List.of(house.state(first), house.state(second))).containsOnly(GoalState.RUNNING);
    assertThat(house.run(2, Duration.ofMinutes(5))).as(house.told()).isTrue();
    assertThat(house.outcomes.values()).allMatch(GoalOutcome::reached);
    assertThat(house.told()).doesNotContain("Stands back");
  }

  /** Keeping still is worth 48; fetching, 15 at first, and 150 in the end. */
  @Test
  void asTimePassesTheRankingFlips() {
    String still = house.wish(request("(keep (in rose zone-a))", stakes("60")));
    house.clock.run(Duration.ofSeconds(5));
    String fetch =
        house.wish(request("(in Cup zone-c)", stakes("40").allowed(Duration.ofSeconds(600))));
    house.clock.run(Duration.ofSeconds(100));

    assertThat(house.state(still)).as(house.told()).isEqualTo(GoalState.HOLDING);
    assertThat(house.state(fetch)).as(house.told()).isEqualTo(GoalState.WAITING);
    assertThat(house.status(fetch).detail()).contains(still + " goes first (its u·g is 48");
    assertThat(house.calls).isEmpty();

    house.run(1, Duration.ofMinutes(10));

    GoalOutcome fetched = house.outcomes.get(fetch);
    assertThat(fetched.reached()).as(house.told()).isTrue();
    // 15·g is five percent or so above 48 when g is 3.2 to 3.4, which is after 147 to 160 s.
    assertThat(fetched.duration()).isBetween(Duration.ofSeconds(155), Duration.ofSeconds(200));
    assertThat(house.told()).contains(still + " WAIT Stands back: " + fetch + " goes first (its");
    house.clock.run(Duration.ofMinutes(1));
    assertThat(house.state(still)).as(house.told()).isEqualTo(GoalState.HOLDING);
    assertThat(house.place).containsEntry("Cup", "zone-c").containsEntry("rose", "zone-a");
  }

  @Test
  void anOperatorsWordStands() {
    String still = house.wish(request("(keep (in rose zone-a))", stakes("1000000")));
    house.clock.run(Duration.ofSeconds(5));
    String fetch = house.wish("(in Cup zone-c)", 1, Optional.empty());
    house.run(1, Duration.ofMinutes(5));

    assertThat(house.outcomes.get(fetch).reached()).as(house.told()).isTrue();
    assertThat(house.told()).contains(still + " WAIT Stands back: " + fetch + " goes first.");
  }

  @Test
  void whatCostsMoreThanItBringsIsBegunWhenThatChanges() {
    house.knowledge.state(
        new Source(Source.Kind.STATED, "meter"), List.of("(= (charge rose) 0.4)"));
    String wish = house.wish(request("(in Cup zone-c)", stakes("(* 40 (charge rose))")));
    house.clock.run(Duration.ofMinutes(2));

    assertThat(house.state(wish)).isEqualTo(GoalState.WAITING);
    assertThat(house.status(wish).detail()).isEqualTo("not worth it: 12.8 against 17");
    assertThat(house.calls).isEmpty();
    assertThat(house.told()).contains("It is not worth it: 12.8 against 17");

    house.knowledge.state(new Source(Source.Kind.STATED, "meter"), List.of("(= (charge rose) 1)"));
    assertThat(house.run(1, Duration.ofMinutes(5))).as(house.told()).isTrue();
    assertThat(house.outcomes.get(wish).reached()).as(house.told()).isTrue();
  }

  /** It is looked at now and then, for as long as it takes, and not at each step of a robot. */
  @Test
  void whatIsNotWorthItNowOutlastsAllChanges() {
    String wish = house.wish(request("(in Cup zone-c)", stakes("(* 10 (charge rose))")));
    house.knowledge.state(new Source(Source.Kind.STATED, "meter"), List.of("(= (charge rose) 1)"));
    for (int i = 0; i < 4_000; i++) {
      house.clock.run(Duration.ofSeconds(1));
      house.with("rose", i % 2 == 0 ? "zone-b" : "zone-a").with("Cup", "zone-b");
    }

    assertThat(house.state(wish)).as(house.told()).isEqualTo(GoalState.WAITING);
    assertThat(house.status(wish).detail()).startsWith("not worth it: 8 against 1");
    assertThat(house.calls).isEmpty();
    long plans = house.story.stream().filter(told -> told.contains(" PLAN ")).count();
    assertThat(plans).isBetween(60L, 140L);
  }

  @Test
  void theChanceIsLearnedFromGoalsOfTheSameShape() {
    String first = house.wish(request("(in Cup zone-c)", stakes("100")));
    assertThat(worth(first).chance()).isEqualTo(0.8);
    house.run(1, Duration.ofMinutes(5));
    String second = house.wish(request("(in Cup zone-a)", stakes("100")));

    assertThat(worth(second).tried()).isEqualTo(1);
    assertThat(worth(second).chance()).isCloseTo((1 + 1.6) / 3, within(1e-9));
    house.die("rose");
    house.run(2, Duration.ofMinutes(5));
    String third = house.wish(request("(in Cup zone-b)", stakes("100")));

    assertThat(worth(third).chance()).as(house.told()).isCloseTo((1 + 1.6) / 4, within(1e-9));
    String other = house.wish(request("(in rose zone-b)", stakes("100")));
    assertThat(worth(other).tried()).as("a robot is no item").isZero();
  }

  @Test
  void whatIsLearnedAndStatedSurvivesARestart() throws IOException {
    PretendHouse bob = new PretendHouse(RestartTest.bobsHome());
    bob.achieve("(in rose zone-a)");
    bob.achieve("(in rose zone-b)");
    String kept =
        bob.coordinator.submit(
            request(
                "(keep (in rose zone-b))",
                stakes("(+ 1 (charge rose))").allowed(Duration.ofHours(1))),
            outcome -> {});
    String open = bob.coordinator.submit(request("(in rose zone-a)", stakes("1")), outcome -> {});
    bob.clock.run(Duration.ofSeconds(5));
    Worth before = status(bob, open);
    bob.restart(outcome -> {});
    bob.clock.run(Duration.ofSeconds(20));

    assertThat(before.tried()).isEqualTo(2);
    assertThat(status(bob, open).chance()).isEqualTo(before.chance()).isEqualTo(3.6 / 4);
    assertThat(status(bob, open).benefit()).hasValue(1);
    assertThat(status(bob, kept).allowed()).contains(Duration.ofHours(1));
  }

  private static Worth status(PretendHouse house, String goal) {
    return house.coordinator.goals().stream()
        .filter(status -> status.id().equals(goal))
        .findFirst()
        .orElseThrow()
        .worth()
        .orElseThrow();
  }

  /** Nine goals of more worth are always there; the tenth grows until it is served. */
  @Test
  void nobodyStarvesForAnHour() {
    assertThat(servedWithinAnHour(10)).isTrue();
    assertThat(servedWithinAnHour(1)).as("without growing urgency it would not be").isFalse();
  }

  private boolean servedWithinAnHour(double urgencyTo) {
    NarrowHouse busy = new NarrowHouse(home, 7).with("rose", "zone-a").with("Cup", "zone-b");
    Random random = new Random(7);
    BUSY.forEach(item -> busy.with(item, "zone-a"));
    for (int i = 0; i < COMPETITORS; i++) {
      again(busy, BUSY.get(i % BUSY.size()), random);
    }
    Stakes few =
        new Stakes(
            SlParser.expression("50"), 0.8, Optional.of(Duration.ofMinutes(20)), 1, urgencyTo);
    String low = busy.wish(request("(in Cup zone-c)", few));
    busy.clock.run(Duration.ofHours(1));
    assertThat(busy.accidents).isEmpty();
    return Optional.ofNullable(busy.outcomes.get(low)).filter(GoalOutcome::reached).isPresent();
  }

  private static void again(NarrowHouse house, String item, Random random) {
    String zone = List.of("zone-a", "zone-b", "zone-c").get(random.nextInt(3));
    house.coordinator.submit(
        request(
            "(in %s %s)".formatted(item, zone), stakes(String.valueOf(100 + random.nextInt(50)))),
        outcome ->
            house.clock.schedule(Duration.ofSeconds(1), "us", () -> again(house, item, random)));
  }

  @Test
  void aBenefitOfUnknownWordsIsRefused() {
    assertThatThrownBy(
            () -> house.wish(request("(in Cup zone-c)", stakes("(* 2 (spills zone-a))"))))
        .isInstanceOf(InvalidGoalException.class)
        .hasMessageContaining("The benefit")
        .hasMessageContaining("spills");
    assertThatThrownBy(() -> house.wish(request("(in Cup zone-c)", stakes("(charge ?robot)"))))
        .hasMessageContaining("?robot open");
  }

  private Worth worth(String goal) {
    return house.status(goal).worth().orElseThrow();
  }

  private static Stakes stakes(String benefit) {
    return new Stakes(SlParser.expression(benefit));
  }

  private static GoalRequest request(String goal, Stakes stakes) {
    return new GoalRequest(SlParser.formula(goal), "Bob", 0, Optional.empty(), Optional.of(stakes));
  }
}
