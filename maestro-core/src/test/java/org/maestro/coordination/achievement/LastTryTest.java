package org.maestro.coordination.achievement;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.PretendHouse;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** What cannot be done for a moment is not called impossible. */
class LastTryTest {
  private static final Duration MOMENT = Duration.ofSeconds(4);
  private static final Duration LONGER = Duration.ofSeconds(12);

  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = LastTryTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);

  private boolean isOver() {
    return house.clock.now().compareTo(MOMENT) > 0;
  }

  @Test
  void aStepThatFailedTwiceIsTriedOnceMoreBeforeTheGoalIsGivenUp() {
    house.dead.add("rose");
    house.beforeCall = call -> house.dead.removeIf(member -> isOver());

    GoalOutcome outcome = house.achieve("(in rose zone-a)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).filteredOn("move rose"::equals).hasSize(3);
  }

  @Test
  void whatFailsThenTooIsGivenUpWithWhatWasTried() {
    house.dead.add("rose");

    GoalOutcome outcome = house.achieve("(in rose zone-a)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(String.join(" ", outcome.reasons()))
        .contains("it was asked for 3 times with the same facts, in vain: rose does not answer");
    assertThat(house.calls).filteredOn("move rose"::equals).hasSize(3);
  }

  @Test
  void aPriceThatWasDeclinedIsAskedForOnceMore() {
    house.declines = feature -> feature.equals("move") && !isOver();

    GoalOutcome outcome = house.achieve("(in rose zone-a)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
  }

  @Test
  void aPriceThatIsDeclinedAgainIsAskedForOnceMoreAfterALongerWhile() {
    house.declines = feature -> feature.equals("move") && house.clock.now().compareTo(LONGER) < 0;

    GoalOutcome outcome = house.achieve("(in rose zone-a)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
  }

  @Test
  void aWayThatStaysBlockedIsGivenUpAndNotCalledImpossible() {
    house.declines = "move"::equals;

    GoalOutcome outcome = house.achieve("(in rose zone-a)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(outcome.endedAt()).isLessThan(Duration.ofMinutes(1));
    assertThat(outcome.reasons()).last().asString().contains("not proven to be impossible");
  }

  @Test
  void whatEarlierStepsMayClearIsTriedBeforeTheGoalIsGivenUp() {
    house.ambientLux.put("zone-b", 100.0);
    house.declines = feature -> feature.equals("move") && !house.calls.contains("pick rose");

    GoalOutcome outcome = house.achieve("(in Cup zone-a)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.place).containsEntry("Cup", "zone-a");
  }

  @Test
  void whatAStepThatFailedLeftOpenIsNoProof() {
    house.ambientLux.put("zone-a", 100.0);
    house.ambientLux.put("zone-b", 100.0);
    house.beforeCall =
        call -> {
          if (call.equals("place rose")) {
            house.dead.add("rose");
            house.place.put("Cup", "nobody-knows-where");
          } else {
            house.dead.clear();
          }
        };

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(house.calls).contains("place rose");
    assertThat(String.join(" ", outcome.reasons()))
        .as(String.join("\n", house.story))
        .contains("if Cup were in rose")
        .contains("not proven to be impossible");
  }

  @Test
  void aGoalThatWaitsForItsLastTryCanBeCancelled() {
    house.dead.add("rose");
    house.clock.schedule(MOMENT, "us", () -> house.coordinator.cancel("G1", "Bob"));

    GoalOutcome outcome = house.achieve("(in rose zone-a)");
    house.clock.run(Duration.ofSeconds(20));

    assertThat(outcome.state()).isEqualTo(GoalState.CANCELLED);
    assertThat(house.calls).filteredOn("move rose"::equals).hasSize(2);
  }
}
