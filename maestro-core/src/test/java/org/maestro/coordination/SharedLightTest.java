package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;

/** Goals that want different light in one room. */
class SharedLightTest {
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = SharedLightTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);
  private final List<GoalOutcome> ended = new ArrayList<>();

  private String wish(String goal, int priority) {
    return house.coordinator.submit(
        new GoalRequest(
            SlParser.formula(goal, home.vocabulary()::isFluent),
            "Bob",
            priority,
            java.util.Optional.empty()),
        ended::add);
  }

  private GoalStatus status(String id) {
    return house.coordinator.goals().stream().filter(g -> g.id().equals(id)).findFirst().get();
  }

  @Test
  void aLampThatALookNeedsIsNotDimmedUntilTheLookIsOver() {
    String look = wish("(canSee cam-b Cup)", 0);
    house.clock.runUntil(() -> house.calls.contains("observeObject cam-b"), Duration.ofMinutes(1));
    String dark = wish("(<= (illuminance zone-b) 40)", 0);
    double[] leastLux = {1000};
    house.beforeCall =
        call -> {
          if (call.startsWith("observeObject")) {
            leastLux[0] = Math.min(leastLux[0], house.lux("zone-b"));
          }
        };
    house.clock.runUntil(() -> ended.size() == 2, Duration.ofMinutes(5));

    assertThat(ended).as(String.join("\n", house.story)).hasSize(2).allMatch(GoalOutcome::reached);
    assertThat(leastLux[0]).isGreaterThanOrEqualTo(72);
    assertThat(ended).extracting(GoalOutcome::id).containsExactly(look, dark);
    assertThat(house.calls).filteredOn(c -> c.equals("observeObject cam-b")).hasSize(1);
  }

  @Test
  void theReasonOfWaitingNamesTheLight() {
    String look = wish("(canSee cam-b Cup)", 0);
    house.clock.runUntil(() -> house.calls.contains("observeObject cam-b"), Duration.ofMinutes(1));
    String dark = wish("(<= (illuminance zone-b) 40)", 0);
    house.clock.runUntil(
        () -> status(dark).state() == GoalState.WAITING || status(dark).state().isFinal(),
        Duration.ofMinutes(1));

    assertThat(status(dark).waits()).isNotEmpty().allMatch(edge -> edge.holder().equals(look));
    assertThat(status(dark).detail()).contains(look);
  }

  @Test
  void whatIsKeptForGoodIsNotSpoiledAndTheReasonNamesIt() {
    String kept = wish("(keep (>= (illuminance zone-b) 30))", 0);
    house.clock.runUntil(() -> status(kept).state() == GoalState.HOLDING, Duration.ofMinutes(1));
    String dark = wish("(<= (illuminance zone-b) 20)", 0);
    house.clock.runUntil(() -> status(dark).state().isFinal(), Duration.ofMinutes(5));

    assertThat(status(dark).state()).as(String.join("\n", house.story)).isEqualTo(GoalState.FAILED);
    assertThat(status(dark).detail()).contains(kept);
    assertThat(status(kept).state()).isEqualTo(GoalState.HOLDING);
    assertThat(house.lux("zone-b")).isGreaterThanOrEqualTo(30);
  }

  @Test
  void whoIsMoreImportantThanWhatIsKeptGoesFirstAndThenItIsKeptAgain() {
    String kept = wish("(keep (>= (illuminance zone-b) 30))", 0);
    house.clock.runUntil(() -> status(kept).state() == GoalState.HOLDING, Duration.ofMinutes(1));
    String dark = wish("(<= (illuminance zone-b) 20)", 3);
    house.clock.runUntil(() -> status(dark).state().isFinal(), Duration.ofMinutes(5));

    assertThat(status(dark).state())
        .as(String.join("\n", house.story))
        .isEqualTo(GoalState.ACHIEVED);
    house.clock.runUntil(() -> status(kept).state() == GoalState.HOLDING, Duration.ofMinutes(5));
    assertThat(status(kept).state())
        .as(String.join("\n", house.story))
        .isEqualTo(GoalState.HOLDING);
    assertThat(String.join("\n", house.story)).contains(dark + " goes first");
  }

  @Test
  void twoKeptWishesThatExcludeEachOtherEndWithAReasonNotInAFight() {
    String light = wish("(keep (>= (illuminance zone-b) 30))", 0);
    house.clock.runUntil(() -> status(light).state() == GoalState.HOLDING, Duration.ofMinutes(1));
    String dark = wish("(keep (<= (illuminance zone-b) 20))", 0);
    house.clock.run(Duration.ofMinutes(2));

    assertThat(status(light).state()).isEqualTo(GoalState.HOLDING);
    assertThat(status(dark).state())
        .as(String.join("\n", house.story))
        .isNotEqualTo(GoalState.HOLDING);
    assertThat(status(dark).detail()).contains(light);
    assertThat(house.calls).filteredOn(c -> c.startsWith("adjustLight")).hasSizeLessThan(4);
  }

  @Test
  void twoSuchWishesAtOnceDoNotFightEither() {
    String light = wish("(keep (>= (illuminance zone-b) 30))", 0);
    String dark = wish("(keep (<= (illuminance zone-b) 20))", 0);
    house.clock.run(Duration.ofMinutes(5));

    assertThat(house.calls)
        .as(String.join("\n", house.story))
        .filteredOn(c -> c.startsWith("adjustLight"))
        .hasSizeLessThan(6);
    assertThat(status(light).detail() + status(dark).detail()).containsAnyOf(light, dark);
  }
}
