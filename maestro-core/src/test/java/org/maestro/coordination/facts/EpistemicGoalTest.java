package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.PretendHouse;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** What nobody can bring about may be so already: somebody looks before it is called impossible. */
class EpistemicGoalTest {
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = EpistemicGoalTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);

  EpistemicGoalTest() {
    house.ambientLux.put("zone-a", 100.0);
    house.ambientLux.put("zone-b", 100.0);
    house.coordinator.memberLost("rose", "no power");
  }

  @Test
  void whatIsSoAlreadyNeedsNobodyWhoActs() {
    house.place.put("Cup", "zone-a");

    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).allMatch(call -> call.contains("cam-") || call.contains("lux-"));
  }

  @Test
  void soItIsForWhatIsNotToBe() {
    assertThat(house.achieve("(not (nextTo Cup Bob))").reached())
        .as(String.join("\n", house.story))
        .isTrue();
  }

  @Test
  void whatIsNotSoIsGivenUpForTheReasonThatNobodyActs() {
    GoalOutcome outcome = house.achieve("(nextTo Cup Bob)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(String.join(" ", outcome.reasons())).contains("rose is needed and not there");
    assertThat(house.calls)
        .contains("observeObject cam-a", "observeObject cam-b")
        .noneMatch(call -> call.contains("rose"));
  }

  @Test
  void whatWasSeenAlreadyIsNotLookedForAgain() {
    house.achieve("(nextTo Cup Bob)");
    int calls = house.calls.size();

    assertThat(house.achieve("(nextTo Cup Bob)").reached()).isFalse();
    assertThat(house.calls).hasSize(calls);
  }

  /** A number that follows from where things are is known as soon as they have been seen. */
  @Test
  void soItIsForANumberThatIsReckonedFromPlaces() {
    house.place.put("Cup", "zone-a");

    GoalOutcome outcome = house.achieve("(<= (distance Cup Bob) 1)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).contains("observeObject cam-a");
  }

  @Test
  void andForATruthThatIs() {
    house.place.put("Cup", "zone-a");

    assertThat(house.achieve("(inside Cup zone-a)").reached())
        .as(String.join("\n", house.story))
        .isTrue();
  }

  /** Whoever carries the cup to Bob brings it about, though no description says so. */
  @Test
  void aNumberReckonedFromPlacesIsNeverCalledImpossible() {
    house.coordinator.memberPresent("rose");

    GoalOutcome outcome = house.achieve("(<= (distance Cup Bob) 1)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(house.calls).contains("observeObject cam-a", "observeObject cam-b");
    assertThat(String.join(" ", outcome.reasons()))
        .contains("It is not so now that the distance of Cup, Bob is at most 1 m")
        .contains("not proven to be impossible")
        .doesNotContain("obody can");
  }

  @Test
  void whereNobodyFindsTheThingsItIsSaidThatItIsNotKnown() {
    house.place.put("Cup", "nowhere");

    GoalOutcome outcome = house.achieve("(<= (distance Cup Bob) 1)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(String.join(" ", outcome.reasons()))
        .contains("It is not known whether the distance of Cup, Bob is at most 1 m")
        .contains("Cup was looked for in vain")
        .doesNotContain("obody can");
  }

  /** The cameras that could look are no part of a goal that nothing is known to bring about. */
  @Test
  void whoWasNotAskedCanLookAllTheSame() {
    home.devices().keySet().forEach(device -> house.coordinator.memberPresent(device));

    GoalOutcome outcome = house.achieve("(>= (mass Cup) 1)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(String.join(" ", outcome.reasons())).doesNotContain("nobody can look");
  }
}
