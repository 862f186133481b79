package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.HomeLoader;

/** What was observed some time ago is observed again before a goal is called reached. */
class SeenLatelyTest {
  private static final Duration SOME_TIME = Duration.ofSeconds(60);

  private PretendHouse house;

  @BeforeEach
  void furnish() throws IOException {
    try (InputStream turtle = SeenLatelyTest.class.getResourceAsStream("/bob.ttl")) {
      house =
          new PretendHouse(
              new HomeLoader()
                  .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl"));
    }
    house.ambientLux.put("zone-a", 100.0);
    house.ambientLux.put("zone-b", 100.0);
    observe("cam-b", "(position Cup \"4.5 1.5 0\")");
  }

  @Test
  void whatSomebodyMovedSinceIsNotCalledInItsPlace() {
    house.clock.run(SOME_TIME);
    house.place.put("Cup", "zone-a");

    GoalOutcome outcome = house.achieve("(in Cup zone-b)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).contains("observeObject cam-b", "pick rose");
    assertThat(house.place).containsEntry("Cup", "zone-b");
  }

  @Test
  void whatIsLookedForInVainBesideTheOtherIsNotReachedByItsDoersWord() {
    house.made.put(
        "place rose",
        step -> {
          house.place.put("Cup", "away");
          return PretendHouse.succeeded(Map.of());
        });

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isFalse();
    assertThat(outcome.reasons().get(0))
        .isEqualTo(
            "It cannot be said to be so: rose says so; but cam-a tells: Cup is not in zone-a.");
    assertThat(house.calls)
        .containsSubsequence("place rose", "observeObject cam-a", "observeObject cam-b");
  }

  @Test
  void whatSomebodyBroughtSinceIsNotCalledAbsent() {
    observe("cam-a", "(not (in Cup zone-a))");
    house.clock.run(SOME_TIME);
    house.place.put("Cup", "zone-a");

    GoalOutcome outcome = house.achieve("(not (in Cup zone-a))");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.place.get("Cup")).isNotEqualTo("zone-a");
  }

  @Test
  void lightThatWasMeasuredLongAgoIsMeasuredAgain() {
    observe("lux-b", "(= (illuminance zone-b) 100)");
    house.clock.run(SOME_TIME);
    house.ambientLux.put("zone-b", 17.0);

    GoalOutcome outcome = house.achieve("(>= (illuminance zone-b) 72)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.lux("zone-b")).isGreaterThanOrEqualTo(72);
  }

  @Test
  void whoDeclinedForLackOfLightIsNoWitnessOfTheLight() {
    observe("cam-a", "(= (illuminance zone-a) 30)");

    GoalOutcome outcome = house.achieve("(<= (illuminance zone-a) 50)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isFalse();
    assertThat(house.calls).contains("measureIllumination lux-a");
  }

  @Test
  void whatWasSeenJustNowNeedsNoLook() {
    GoalOutcome outcome = house.achieve("(in Cup zone-b)");

    assertThat(outcome.confirmed()).isTrue();
    assertThat(house.calls).isEmpty();
  }

  @Test
  void howLongAgoItWasSeenIsToldWhereNobodyCanLookAgain() {
    house.coordinator.memberLost("cam-b", "no power");
    house.clock.run(SOME_TIME);

    GoalOutcome outcome = house.achieve("(in Cup zone-b)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.confirmed()).isFalse();
    assertThat(outcome.reasons().get(0)).matches("It was so when it was observed 6\\d s ago; .*");
  }

  @Test
  void howFarThingsAreApartRestsOnWhereTheyAreSeen() {
    observe("cam-a", "(position Bob \"1.9 1.5 0\")");
    house.clock.run(Duration.ofSeconds(20));

    GoalOutcome outcome = house.achieve("(>= (distance Cup Bob) 1)");

    assertThat(outcome.confirmed()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).contains("observeObject cam-a", "observeObject cam-b");
  }

  @Test
  void thatItIsElsewhereByTheWordOfItsCarrierIsNotSeen() {
    GoalOutcome outcome = house.achieve("(not (in Cup zone-b))");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.confirmed()).as(String.join("\n", house.story)).isFalse();
    assertThat(String.join(" ", outcome.reasons())).contains("rose says");
  }

  /** A look that failed is repeated only as long as it may still lead somewhere. */
  @Test
  void aLookThatFailsAgainAndAgainIsNotRepeatedForEver() {
    house.beforeCall =
        call -> {
          if (call.equals("place rose")) {
            house.dead.add("cam-a");
          }
        };

    GoalOutcome outcome = house.achieve("(in Cup zone-a)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.confirmed()).isFalse();
    assertThat(house.place).containsEntry("Cup", "zone-a");
    assertThat(house.calls).filteredOn("observeObject cam-a"::equals).hasSizeBetween(1, 3);
  }

  private void observe(String sensor, String fact) {
    house.knowledge.state(new Source(Source.Kind.OBSERVED, sensor), List.of(fact));
  }
}
