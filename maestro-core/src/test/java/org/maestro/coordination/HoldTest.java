package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.contention.ResourceClaimsTest;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.sl.SlParser;

/** What a script holds is its own between its steps, but for who goes first. */
class HoldTest {
  private static final Duration LONG = Duration.ofMinutes(10);

  private static Home home;

  private final Map<String, Script> scripts = new TreeMap<>();
  private NarrowHouse house;

  @BeforeAll
  static void loadHome() throws IOException {
    home = ResourceClaimsTest.narrowHome();
  }

  private void script(String name, String body) {
    scripts.put(
        name, new Script(name, List.of(), SlParser.body(body, home.vocabulary()::isFluent)));
  }

  private void house() {
    house =
        new NarrowHouse(home.withScripts(scripts), 1).with("rose", "zone-a").with("Cup", "zone-b");
  }

  /** Without holding it the robot is taken as soon as the first step is over. */
  @Test
  void nobodyTakesTheRobotBetweenTwoSteps() {
    script("guard", "(hold rose \"base\" (do move rose :to zone-b) (wait 60))");
    script("stand", "(seq (do move rose :to zone-b) (wait 60))");
    assertThat(secondsUntilTaken("(guard)")).isGreaterThan(60);
    assertThat(house.told())
        .contains("G2 WAIT Waits: the base of rose is held by G1.1.")
        .contains("G1 STEP [1] Keep the base of rose for the steps in it.")
        .contains("G1 DONE [1.1.1] ");
    assertThat(secondsUntilTaken("(stand)")).isLessThan(40);
  }

  private double secondsUntilTaken(String script) {
    house();
    house.wish(script);
    house.clock.run(Duration.ofSeconds(1));
    String other = house.wish("(in rose zone-c)");
    assertThat(house.run(2, LONG)).as(house.told()).isTrue();
    assertThat(house.outcomes.get("G1").reached()).as(house.told()).isTrue();
    assertThat(house.accidents).isEmpty();
    return house.outcomes.get(other).duration().toMillis() / 1000.0;
  }

  @Test
  void whoGoesFirstGetsItAtASafePointAndItIsHeldAgainAfterwards() {
    script(
        "guard",
        "(hold rose \"base\" (do move rose :to zone-b) (wait 60) (achieve (in rose zone-b)))");
    house();
    String guard = house.wish("(guard)");
    house.clock.run(Duration.ofSeconds(1));
    String first = house.wish("(in Cup zone-a)", 5, Optional.empty());
    house.clock.runUntil(() -> house.outcomes.containsKey(first), LONG);
    house.clock.run(Duration.ofSeconds(1));
    String later = house.wish("(in rose zone-c)");
    assertThat(house.run(3, LONG)).as(house.told()).isTrue();

    assertThat(house.outcomes.keySet()).as(house.told()).containsExactly(first, guard, later);
    assertThat(house.outcomes.values()).allMatch(GoalOutcome::reached);
    assertThat(house.outcomes.get(first).duration()).isLessThan(Duration.ofSeconds(50));
    assertThat(house.told())
        .contains(
            guard + " WAIT [1] Stands back: " + first + " goes first with the base of rose.",
            guard + " WAIT [1] Goes on.",
            guard + " DONE [1] Lets go of the base of rose.",
            later + " WAIT Waits: the base of rose is held by " + guard + ".1.");
    assertThat(house.calls.get(0)).isEqualTo("move rose");
    assertThat(house.accidents).isEmpty();
  }

  /** Each holds one robot and wants the other's. */
  @Test
  void ofTwoThatWaitForEachOtherTheLaterOneStepsBack() {
    script("here", "(hold rose \"base\" (wait 10) (do move tim :to zone-b))");
    script("there", "(hold tim \"base\" (wait 10) (do move rose :to zone-b))");
    house();
    house.with("tim", "zone-c");
    String here = house.wish("(here)");
    String there = house.wish("(there)");
    assertThat(house.run(2, LONG)).as(house.told()).isTrue();

    assertThat(house.outcomes.keySet()).as(house.told()).containsExactly(here, there);
    assertThat(house.outcomes.values()).allMatch(GoalOutcome::reached);
    assertThat(house.told()).contains(there + " WAIT [1] Stands back: " + here);
    assertThat(house.accidents).isEmpty();
  }

  @Test
  void aLoopHoldsItAsLongAsItsConditionHolds() {
    script("still", "(while (in Cup zone-b) (hold rose \"base\"))");
    house();
    String still = house.wish("(still)");
    house.clock.run(Duration.ofSeconds(1));
    String other = house.wish("(in rose zone-c)");
    house.clock.run(Duration.ofMinutes(5));
    assertThat(house.state(still)).isEqualTo(GoalState.RUNNING);
    assertThat(house.state(other)).as(house.told()).isEqualTo(GoalState.WAITING);
    assertThat(house.calls).isEmpty();

    house.knowledge.state(
        new Source(Source.Kind.STATED, "us"), List.of("(in Cup zone-c)", "(not (in Cup zone-b))"));
    assertThat(house.run(2, LONG)).as(house.told()).isTrue();
    assertThat(house.outcomes.keySet()).containsExactly(still, other);
    assertThat(house.outcomes.values()).allMatch(GoalOutcome::reached);
  }

  @Test
  void stepsThatAreHeldForKeepNothingFromEachOtherButWhileTheyUseIt() {
    script(
        "both", "(hold rose \"base\" (par (achieve (in Cup zone-a)) (do move rose :to zone-b)))");
    house();
    String both = house.wish("(both)");
    assertThat(house.run(1, LONG)).as(house.told()).isTrue();

    assertThat(house.outcomes.get(both).reached()).as(house.told()).isTrue();
    assertThat(house.accidents).isEmpty();
  }

  @Test
  void whatEndsItsStepsEndsTheHoldingToo() {
    script(
        "fails",
        "(try (hold rose \"base\" (wait 5) (fail \"bored\")) (recover \"bored\" (wait 300)))");
    script("gives", "(hold rose \"base\" (wait 5) (return rose))");
    script("waits", "(hold rose \"base\" (wait 600))");
    for (String script : List.of("fails", "gives", "waits")) {
      house();
      String id = house.wish("(" + script + ")");
      house.clock.run(Duration.ofSeconds(1));
      String other = house.wish("(in rose zone-b)");
      if (script.equals("waits")) {
        house.clock.run(Duration.ofSeconds(10));
        house.coordinator.cancel(id, "Bob");
      }
      house.clock.runUntil(() -> house.outcomes.containsKey(other), LONG);
      assertThat(house.outcomes.get(other).duration())
          .as(house.told())
          .isLessThan(Duration.ofMinutes(1));
      house.clock.run(LONG);
      assertThat(house.outcomes.get(id).state())
          .isEqualTo(script.equals("waits") ? GoalState.CANCELLED : GoalState.ACHIEVED);
    }
    assertThat(house.coordinator.waits()).isEmpty();
  }
}
