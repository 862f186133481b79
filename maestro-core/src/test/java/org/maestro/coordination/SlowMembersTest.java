package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** Who says nothing for long may be at it still, and is asked what became of it. */
class SlowMembersTest {
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = SlowMembersTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);
  private final List<ActionDispatcher.Request> drives = new ArrayList<>();

  @Test
  void areAskedAgainByTheSameCallAndNotCalledAnew() {
    house.coordinator.memberPresent("rose", Optional.of("b1@CCA"));
    silentUntil(2);

    GoalOutcome outcome = house.achieve("(in rose zone-a)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(drives).hasSize(2);
    assertThat(drives).extracting(order -> order.call().orElseThrow().id()).containsOnly(id());
    assertThat(drives)
        .extracting(ActionDispatcher.Request::parameters)
        .containsOnly(drives.get(0).parameters());
    assertThat(house.story)
        .anyMatch(
            told ->
                told.contains(
                    "rose is asked what became of step 1, which is no second time: rose drives to"
                        + " zone-a."));
  }

  @Test
  void areCalledAnewWhenTheyLiveAnotherLife() {
    house.coordinator.memberPresent("rose", Optional.of("b1@CCA"));
    silentUntil(2);
    house.beforeCall =
        call -> {
          if (call.equals("move rose")) {
            house.coordinator.memberPresent("rose", Optional.of("b2@CCA"));
          }
        };

    GoalOutcome outcome = house.achieve("(in rose zone-a)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(drives).extracting(order -> order.call().orElseThrow().id()).doesNotHaveDuplicates();
  }

  @Test
  void areNotAskedForEver() {
    house.coordinator.memberPresent("rose", Optional.of("b1@CCA"));
    silentUntil(Integer.MAX_VALUE);

    GoalOutcome outcome = house.achieve("(in rose zone-a)");

    assertThat(outcome.reached()).isFalse();
    assertThat(drives).hasSize(3);
    assertThat(drives).extracting(order -> order.call().orElseThrow().id()).containsOnly(id());
    assertThat(outcome.reasons()).anyMatch(reason -> reason.contains("not proven"));
  }

  /** What it says of it afterwards comes too late; it may be at it for ever. */
  @Test
  void areNotLeftAtAStepThatIsNotAwaitedAnyMore() {
    house.mute.add("rose");

    GoalOutcome outcome = house.achieve("(in rose zone-a)");

    assertThat(outcome.reached()).isFalse();
    assertThat(house.story).anyMatch(told -> told.contains("rose has not answered for"));
    assertThat(house.cancelled).containsExactlyElementsOf(drivesOfRose());
  }

  @Test
  void haveThriceTheExpectedTimeOrWhatTheirMakerAllows() {
    house.ordered = drives::add;
    house.achieve("(in rose zone-a)");
    ActionDispatcher.Request usual = drives.get(0);
    Home allowed = new HomeLoader().load(withTimeLimit(), "bob.ttl");
    PretendHouse other = new PretendHouse(allowed);
    other.ordered = drives::add;
    drives.clear();
    other.achieve("(in rose zone-a)");

    Duration bus = Duration.ofSeconds(15);
    assertThat(usual.timeout())
        .isEqualTo(Duration.ofMillis((long) (usual.step().seconds() * 3_000)).plus(bus));
    assertThat(drives.get(0).timeout()).isEqualTo(Duration.ofSeconds(600).plus(bus));
  }

  private static String withTimeLimit() {
    try (InputStream turtle = SlowMembersTest.class.getResourceAsStream("/bob.ttl")) {
      return new String(turtle.readAllBytes(), StandardCharsets.UTF_8)
          + "\n:MobileRobot maestro:offers [ a :move ; maestro:timeLimit 600 ] .\n";
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private List<String> drivesOfRose() {
    return house.calls.stream().filter("move rose"::equals).toList();
  }

  private String id() {
    return drives.get(0).call().orElseThrow().id();
  }

  /** The first so many orders to drive end without a word of the robot. */
  private void silentUntil(int answered) {
    house.ordered =
        order -> {
          if (order.step().feature().procedure().equals("move")) {
            drives.add(order);
          }
        };
    house.reporting =
        (step, report) ->
            step.feature().procedure().equals("move") && drives.size() < answered
                ? new ActionDispatcher.Report(
                    false,
                    Map.of(),
                    Optional.of("rose gave no answer in time"),
                    List.of(),
                    true,
                    Optional.empty(),
                    true)
                : report;
  }
}
