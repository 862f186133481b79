package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Recovery;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;

/** What goals have learnt before a restart of the coordinator counts after it. */
class RestartTest {
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    home = bobsHome();
  }

  static Home bobsHome() throws IOException {
    return new HomeLoader()
        .load(
            Files.readString(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl")),
            "bob.ttl");
  }

  private final PretendHouse house = new PretendHouse(home);
  private final List<GoalOutcome> outcomes = new ArrayList<>();

  @Test
  void whatFailedTooOftenIsNotTriedAgainBecauseOfARestart() {
    PretendHouse undisturbed = new PretendHouse(home);
    undisturbed.dead.addAll(List.of("lamp-b1", "lamp-b2", "lamp-b3"));
    assertThat(undisturbed.achieve("(>= (illuminance zone-b) 72)").reached()).isFalse();

    house.dead.addAll(undisturbed.dead);
    submit("(>= (illuminance zone-b) 72)", Optional.empty());
    await(() -> house.story.stream().anyMatch(text -> text.contains("once more")));
    house.restart(outcomes::add);
    await(() -> !outcomes.isEmpty());

    assertThat(outcomes.get(0).state()).isEqualTo(GoalState.FAILED);
    assertThat(lampCalls(house))
        .as(String.join("\n", house.story))
        .isEqualTo(lampCalls(undisturbed));
  }

  @Test
  void whatAFailureHasTaughtIsKnownAfterARestart() {
    house.heavy.add("Cup");
    house.ambientLux.put("zone-b", 100.0);
    List<Recovery> left = new ArrayList<>();
    house.beforeCall =
        call -> {
          if (call.equals("pick rose") && left.isEmpty()) {
            house.clock.schedule(Duration.ofMillis(5), "the end", () -> left.add(house.recovery()));
          }
        };
    submit("(in Cup rose)", Optional.empty());
    await(() -> !left.isEmpty());
    PretendHouse next = new PretendHouse(home);
    next.heavy.add("Cup");
    next.ambientLux.put("zone-b", 100.0);
    outcomes.clear();

    next.coordinator.resume(left.get(0), Duration.ofSeconds(10), outcomes::add);
    next.clock.runUntil(() -> !outcomes.isEmpty(), Duration.ofMinutes(5));

    assertThat(outcomes.get(0).state()).isEqualTo(GoalState.FAILED);
    assertThat(String.join(" ", outcomes.get(0).reasons())).contains("mass of Cup");
    assertThat(next.calls).doesNotContain("pick rose");
  }

  /** Its agent ends here and begins in another process, before all the others are back. */
  @Test
  void whoGetsAnotherAgentMeanwhileIsWaitedForToo() {
    String why = "it is getting another agent";
    submit("(nextTo Cup Bob)", Optional.empty());
    house.clock.run(Duration.ofMillis(50));
    PretendHouse next = new PretendHouse(home);
    next.coordinator.memberDoubted("rose", why);
    next.coordinator.memberDoubted("lamp-a1", why);
    next.coordinator.resume(house.recovery(), Duration.ofSeconds(10), outcomes::add);

    next.coordinator.memberTrusted("rose");
    next.coordinator.memberDoubted("rose", why);
    next.coordinator.memberTrusted("lamp-a1");
    next.clock.run(Duration.ofSeconds(1));
    assertThat(next.coordinator.goals().get(0).detail())
        .isEqualTo("for its devices to come back after the restart");

    next.coordinator.memberTrusted("rose");
    next.clock.runUntil(() -> !outcomes.isEmpty(), Duration.ofMinutes(5));
    assertThat(outcomes).extracting(GoalOutcome::reached).containsExactly(true);
  }

  @Test
  void aDeadlineGoesOnToCount() {
    house.stepTakes = Duration.ofSeconds(40);
    submit("(nextTo Cup Bob)", Optional.of(Duration.ofSeconds(60)));
    house.clock.run(Duration.ofMillis(50));
    house.restart(outcomes::add);
    await(() -> !outcomes.isEmpty());

    assertThat(outcomes.get(0).state()).isEqualTo(GoalState.FAILED);
    assertThat(outcomes.get(0).reasons().get(0)).contains("Its deadline has passed");
    assertThat(house.clock.now()).isBetween(Duration.ofSeconds(60), Duration.ofSeconds(61));
  }

  @Test
  void aDeadlineThatPassedMeanwhileEndsTheGoalAtOnce() {
    submit("(nextTo Cup Bob)", Optional.of(Duration.ofSeconds(1)));
    Coordinator former = house.coordinator;
    house.restart(outcomes::add);
    assertThat(former).isNotSameAs(house.coordinator);
    house.clock.run(Duration.ofSeconds(30));

    assertThat(outcomes).extracting(GoalOutcome::state).containsOnly(GoalState.FAILED);
  }

  @Test
  void aGoalThatWasHeldBeforeIsNotEndedByItsDeadline() {
    house.ambientLux.put("zone-b", 100.0);
    submit("(keep (>= (illuminance zone-b) 72))", Optional.of(Duration.ofSeconds(20)));
    await(() -> house.coordinator.goals().get(0).state() == GoalState.HOLDING);
    house.ambientLux.put("zone-b", 10.0);
    house.dead.addAll(List.of("lamp-b1", "lamp-b2", "lamp-b3"));
    await(() -> house.coordinator.goals().get(0).state() == GoalState.WAITING);

    house.restart(outcomes::add);
    house.restart(outcomes::add);
    house.clock.run(Duration.ofSeconds(20));

    assertThat(house.clock.now()).isBetween(Duration.ofSeconds(20), Duration.ofMinutes(1));
    assertThat(outcomes).isEmpty();
  }

  @Test
  void whatAHeldGoalHasSetIsSavedAfterARestartToo() {
    submit("(keep (>= (illuminance zone-b) 72))", Optional.empty());
    await(() -> house.coordinator.goals().get(0).state() == GoalState.HOLDING);
    assertThat(house.lux("zone-b")).isGreaterThanOrEqualTo(72);

    house.restart(outcomes::add);
    house.ambientLux.put("zone-b", 100.0);
    await(() -> house.lux("zone-b") == 100.0);

    assertThat(house.coordinator.goals().get(0).state()).isEqualTo(GoalState.HOLDING);
  }

  private void submit(String goal, Optional<Duration> deadline) {
    house.coordinator.submit(
        new GoalRequest(SlParser.formula(goal), "Bob", 0, deadline), outcomes::add);
  }

  private void await(java.util.function.BooleanSupplier condition) {
    assertThat(house.clock.runUntil(condition, Duration.ofMinutes(20)))
        .as(String.join("\n", house.story))
        .isTrue();
  }

  private static long lampCalls(PretendHouse house) {
    return house.calls.stream().filter(call -> call.startsWith("adjustLight")).count();
  }
}
