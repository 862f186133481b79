package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.AnswerRefusal;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Respondent;
import org.maestro.coordination.contention.ResourceClaimsTest;
import org.maestro.ontology.home.HomeLoader;

/** Scripts with a stated effect, as steps of plans. */
class CompositesTest {
  private static String narrow;

  private NarrowHouse house;

  @BeforeAll
  static void readHome() throws IOException {
    try (InputStream turtle = ResourceClaimsTest.class.getResourceAsStream("/narrow.ttl")) {
      narrow = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static String courier(int cost, String body) {
    return script("courier", "(in ?item ?to)", cost, body);
  }

  private static String script(String name, String effect, int cost, String body) {
    return """

        home:%s a maestro:Script ; maestro:arguments ( "?item - Item" "?to - Zone" ) ;
          maestro:precondition "(not (in ?item ?to))" ; maestro:effect "%s" ; maestro:cost %d ;
          maestro:body "%s" .
        """
        .formatted(name, effect, cost, body);
  }

  private String wish(String scripts, String goal) {
    house =
        new NarrowHouse(new HomeLoader().load(narrow + scripts, "narrow.ttl"), 1)
            .with("rose", "zone-a")
            .with("Cup", "zone-b")
            .with("Mug", "zone-a");
    house.die("tim");
    house.die("una");
    return house.wish(goal);
  }

  private GoalOutcome reach(String scripts, String goal) {
    String id = wish(scripts, goal);
    assertThat(house.run(1, Duration.ofMinutes(10))).as(house.told()).isTrue();
    assertThat(house.accidents).isEmpty();
    return house.outcomes.get(id);
  }

  @Test
  void aScriptThatCostsLessIsAStepOfThePlan() {
    GoalOutcome outcome =
        reach(courier(3, "(seq (achieve (in ?item ?to)) (wait 1))"), "(in Cup zone-c)");

    assertThat(outcome.reached()).as(house.told()).isTrue();
    assertThat(house.place).containsEntry("Cup", "zone-c");
    assertThat(house.told())
        .contains("Plan 1 (cost 3): 1. the script courier is run for Cup, zone-c.")
        .contains("[1.1] Step 2 of 4: rose picks up Cup.");
  }

  @Test
  void aScriptThatCostsMoreIsNone() {
    GoalOutcome outcome = reach(courier(300, "(achieve (in ?item ?to))"), "(in Cup zone-c)");

    assertThat(outcome.reached()).isTrue();
    assertThat(house.told()).doesNotContain("courier is run");
  }

  /** One step of the plan is a script, and others are calls of the same robot. */
  @Test
  void aScriptAndDevicesTakeTurns() {
    GoalOutcome outcome =
        reach(courier(3, "(achieve (in ?item ?to))"), "(and (in Cup zone-c) (in rose zone-a))");

    assertThat(outcome.reached()).as(house.told()).isTrue();
    assertThat(house.place).containsEntry("Cup", "zone-c").containsEntry("rose", "zone-a");
    assertThat(house.told()).contains("courier is run for Cup, zone-c");
  }

  @Test
  void whatAScriptPromisesAndDoesNotDoIsNotBelieved() {
    GoalOutcome outcome = reach(courier(3, "(wait 1)"), "(in Cup zone-c)");

    assertThat(outcome.reached()).as(house.told()).isTrue();
    assertThat(house.place).containsEntry("Cup", "zone-c");
    assertThat(house.told())
        .contains("courier is done, and it is not known that Cup is in zone-c")
        .contains("rose places Cup at zone-c");
  }

  @Test
  void whyAScriptFailedIsToldAndThePlanIsAnother() {
    GoalOutcome outcome = reach(courier(3, "(fail \\\"no wheels\\\")"), "(in Cup zone-c)");

    assertThat(outcome.reached()).as(house.told()).isTrue();
    assertThat(house.told()).contains("courier has failed: no wheels");
  }

  /** Neither carried out for itself nor as a step. */
  @Test
  void aScriptIsNoStepOfWhatItDoesItself() {
    GoalOutcome outcome = reach(courier(3, "(achieve (in ?item ?to))"), "(courier Cup zone-c)");

    assertThat(outcome.reached()).as(house.told()).isTrue();
    assertThat(house.told()).doesNotContain("courier is run for");
    assertThat(house.place).containsEntry("Cup", "zone-c");
  }

  @Test
  void aScriptMayBeAStepWithinAnother() {
    GoalOutcome outcome =
        reach(
            courier(9, "(achieve (in ?item ?to))")
                + script("express", "(in ?item ?to)", 3, "(achieve (in ?item ?to))"),
            "(in Cup zone-c)");

    assertThat(outcome.reached()).as(house.told()).isTrue();
    assertThat(house.told())
        .contains("the script express is run for Cup, zone-c")
        .contains("[1.1] Step 1 of 1: the script courier is run for Cup, zone-c");
  }

  @Test
  void whoCancelsTheGoalHasWhatIsToBeDoneInAnyCaseDone() {
    String id =
        wish(
            courier(3, "(try (achieve (in ?item ?to)) (finally (achieve (in rose zone-a))))"),
            "(in Cup zone-c)");
    house.clock.runUntil(() -> house.calls.contains("pick rose"), Duration.ofMinutes(1));
    house.coordinator.cancel(id, "Bob");
    house.clock.run(Duration.ofMinutes(1));

    assertThat(house.outcomes.get(id).state()).isEqualTo(GoalState.CANCELLED);
    assertThat(house.place).as(house.told()).containsEntry("rose", "zone-a");
  }

  @Test
  void aStepOfAPlanMayAskSomething() {
    String id =
        wish(
            "home:Bob a :Person ; rdfs:label \"Bob\"@en ."
                + courier(
                    3, "(seq (ask Bob \\\"Really?\\\" ?really boolean) (achieve (in ?item ?to)))"),
            "(in Cup zone-c)");
    List<Optional<AnswerRefusal>> told = new ArrayList<>();
    house.clock.run(Duration.ofSeconds(2));
    house.coordinator.answer("G1.1.1", "yes", new Respondent("Bob"), told::add);
    house.clock.runUntil(() -> house.outcomes.containsKey(id), Duration.ofMinutes(5));

    assertThat(told).as(house.told()).containsExactly(Optional.empty());
    assertThat(house.outcomes.get(id).reached()).as(house.told()).isTrue();
    assertThat(house.told()).contains("courier is run for Cup, zone-c");
  }
}
