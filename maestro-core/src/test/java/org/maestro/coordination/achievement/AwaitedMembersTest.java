package org.maestro.coordination.achievement;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.PretendHouse;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.Ports;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;

/** Who was lost moments ago may be back soon: a goal that needs it waits a while. */
class AwaitedMembersTest {
  private static final String GOAL = "(nextTo Cup Bob)";
  private static final Duration SOON = Duration.ofSeconds(6);
  private static final Duration LONG_AGO = Ports.USUAL_COMEBACK.plusSeconds(1);

  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    home = loaded(UnaryOperator.identity());
  }

  private static Home loaded(UnaryOperator<String> changed) throws IOException {
    try (InputStream turtle = AwaitedMembersTest.class.getResourceAsStream("/bob.ttl")) {
      String bob = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
      return new HomeLoader().load(changed.apply(bob), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);

  private void loses(String member) {
    house.dead.add(member);
    house.coordinator.memberLost(member, "no power");
  }

  private void comesBack(String member) {
    house.dead.remove(member);
    house.coordinator.memberPresent(member);
    house.knowledge.state(
        new Source(Source.Kind.STATED, member),
        List.of("(in %s %s)".formatted(member, house.place.get(member))));
  }

  @Test
  void theOnlyRobotIsWaitedForAndTheGoalSaysSo() {
    loses("rose");
    List<GoalStatus> meanwhile = new ArrayList<>();
    house.clock.schedule(
        SOON,
        "test",
        () -> {
          meanwhile.addAll(house.coordinator.goals());
          comesBack("rose");
        });

    GoalOutcome outcome = house.achieve(GOAL);

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(meanwhile.get(0).state()).isEqualTo(GoalState.WAITING);
    assertThat(meanwhile.get(0).detail()).isEqualTo("for rose to come back (no power)");
    assertThat(house.story).anyMatch(line -> line.contains("for rose to come back"));
    assertThat(house.story).anyMatch(line -> line.contains("because rose is there"));
  }

  /** Between its description and its agent a moment passes, in which goals are stated, too. */
  @Test
  void whoHasJustDescribedItselfIsWaitedFor() throws IOException {
    Home withoutRose =
        loaded(
            turtle ->
                turtle.replaceFirst(
                    "home:rose a [^;]+;[^;]+;[^;]+;[^;]+;[^;]+;[^;]+;[^;]+\\.\\n", ""));
    assertThat(withoutRose.devices()).hasSize(home.devices().size() - 1);
    PretendHouse newHouse = new PretendHouse(withoutRose);
    newHouse.knowledge.describe(home.devices().get("rose"));
    newHouse.clock.schedule(
        SOON,
        "test",
        () -> {
          newHouse.coordinator.memberPresent("rose");
          newHouse.knowledge.state(
              new Source(Source.Kind.STATED, "rose"), List.of("(in rose zone-b)"));
        });

    GoalOutcome outcome = newHouse.achieve(GOAL);

    assertThat(outcome.reached()).as(String.join("\n", newHouse.story)).isTrue();
    assertThat(newHouse.story)
        .anyMatch(line -> line.contains("it is waited for rose (its agent is still to come)"))
        .anyMatch(line -> line.contains("because rose is there"));
  }

  @Test
  void whoComesWhileItIsPlannedWithoutItIsTakenIntoAccount() throws IOException {
    loses("rose");
    house.clock.run(LONG_AGO);
    house.clock.schedule(Duration.ofMillis(10), "test", () -> comesBack("rose"));

    GoalOutcome outcome = house.achieve(GOAL);

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.story).anyMatch(line -> line.contains("because rose is there"));
  }

  @Test
  void whoMayHaveWhatIsNowhereElseIsWaitedFor() {
    house.ambientLux.put("zone-a", 100.0);
    house.ambientLux.put("zone-b", 100.0);
    assertThat(house.achieve("(in Cup rose)").reached()).isTrue();
    loses("rose");
    house.clock.schedule(
        SOON,
        "test",
        () -> {
          comesBack("rose");
          house.knowledge.state(new Source(Source.Kind.STATED, "rose"), List.of("(in Cup rose)"));
        });

    GoalOutcome outcome = house.achieve("(canSee ?agent Cup)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.story).anyMatch(line -> line.contains("for rose to come back"));
  }

  @Test
  void whatALostRobotMayHaveIsToldWhenItStaysAway() {
    house.ambientLux.put("zone-a", 100.0);
    house.ambientLux.put("zone-b", 100.0);
    assertThat(house.achieve("(in Cup rose)").reached()).isTrue();
    loses("rose");

    GoalOutcome outcome = house.achieve("(canSee ?agent Cup)");

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(String.join(" ", outcome.reasons()))
        .containsPattern("It may be that Cup is in rose, which is not there \\(lost since \\d+ s");
  }

  @Test
  void whoDoesNotComeBackIsGivenUpInTime() {
    loses("rose");

    GoalOutcome outcome = house.achieve(GOAL);

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(outcome.endedAt()).isBetween(Ports.USUAL_COMEBACK, LONG_AGO);
    assertThat(String.join(" ", outcome.reasons()))
        .contains("rose were there (lost since %d s".formatted(Ports.USUAL_COMEBACK.toSeconds()))
        .doesNotContain("rose is in rose");
  }

  @Test
  void whoWasLostLongAgoIsNotWaitedFor() {
    loses("rose");
    house.clock.run(LONG_AGO);

    GoalOutcome outcome = house.achieve(GOAL);

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(outcome.endedAt()).isLessThan(LONG_AGO.plus(SOON));
    assertThat(house.story).noneMatch(line -> line.contains("to come back"));
  }

  @Test
  void whoWouldNotHelpIsNotWaitedFor() {
    for (String lamp : List.of("lamp-b1", "lamp-b2", "lamp-b3")) {
      loses(lamp);
    }
    house.clock.run(LONG_AGO);
    loses("lamp-a1");

    GoalOutcome outcome = house.achieve(GOAL);

    assertThat(outcome.state()).isEqualTo(GoalState.FAILED);
    assertThat(house.story).noneMatch(line -> line.contains("to come back"));
  }

  @Test
  void whatComesAboutMeanwhileEndsTheWait() {
    for (String lamp : List.of("lamp-b1", "lamp-b2", "lamp-b3")) {
      loses(lamp);
    }
    house.clock.schedule(
        SOON,
        "test",
        () -> {
          house.ambientLux.put("zone-b", 100.0);
          house.knowledge.state(
              new Source(Source.Kind.OBSERVED, "lux-b"), List.of("(= (illuminance zone-b) 100)"));
        });

    GoalOutcome outcome = house.achieve(GOAL);

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
  }

  @Test
  void aDeadlineEndsTheWait() {
    loses("rose");
    List<GoalOutcome> outcome = new ArrayList<>();
    house.coordinator.submit(
        new GoalRequest(SlParser.formula(GOAL), "Bob", 0, Optional.of(SOON)), outcome::add);
    house.clock.runUntil(() -> !outcome.isEmpty(), Duration.ofMinutes(1));

    assertThat(outcome.get(0).endedAt()).isBetween(SOON, SOON.plusSeconds(1));
    assertThat(String.join(" ", outcome.get(0).reasons()))
        .contains("waiting (for rose to come back");
  }
}
