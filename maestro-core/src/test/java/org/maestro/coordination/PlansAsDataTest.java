package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.BidRecord;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.PlanRecord;
import org.maestro.coordination.api.StepRecord;
import org.maestro.coordination.api.StepRecord.State;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;

/** The plans of a goal, what became of their steps, and who had answered what. */
class PlansAsDataTest {
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = PlansAsDataTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);

  private PlanRecord plan(int number) {
    return house.coordinator.plans("G1").stream()
        .filter(plan -> plan.number() == number)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void eachStepIsDoneAfterThoseThatItNeeds() {
    house.ambientLux.put("zone-a", 100.0);
    house.ambientLux.put("zone-b", 100.0);
    house.place.put("Cup", "zone-b");
    assertThat(house.achieve("(in rose zone-a)").reached()).isTrue();

    PlanRecord plan = plan(1);
    assertThat(plan.cause()).isEmpty();
    assertThat(plan.made().orElseThrow().cost()).isPositive();
    assertThat(plan.steps()).isNotEmpty().allMatch(step -> step.state() == State.DONE);
    for (StepRecord step : plan.steps()) {
      assertThat(step.begun().orElseThrow()).isLessThan(step.ended().orElseThrow());
      for (int before : step.step().after()) {
        assertThat(plan.steps().get(before - 1).ended().orElseThrow())
            .isLessThanOrEqualTo(step.begun().orElseThrow());
      }
    }
  }

  @Test
  void aReplanHasItsCauseAndWhatItReplacesIsDropped() {
    house.weak.addAll(List.of("lamp-b1", "lamp-b2", "lamp-b3"));
    assertThat(house.achieve("(nextTo Cup Bob)").reached()).isTrue();

    List<PlanRecord> plans = house.coordinator.plans("G1");
    assertThat(plans).hasSizeGreaterThan(1);
    assertThat(plans.get(1).cause().orElseThrow()).isNotEmpty();
    assertThat(plans.get(0).steps()).extracting(StepRecord::state).contains(State.DROPPED);
    assertThat(plans.stream().flatMap(plan -> plan.steps().stream()))
        .extracting(StepRecord::state)
        .doesNotContain(State.WAITING, State.UNDER_WAY);
  }

  @Test
  void aStepThatFailsSaysWhy() {
    house.beforeCall =
        call -> {
          if (call.equals("adjustLight lamp-b2")) {
            house.dead.add("lamp-b2");
          }
        };
    house.achieve("(nextTo Cup Bob)");

    assertThat(house.coordinator.plans("G1").stream().flatMap(plan -> plan.steps().stream()))
        .filteredOn(step -> step.state() == State.FAILED)
        .isNotEmpty()
        .allSatisfy(step -> assertThat(step.problem().orElseThrow()).contains("does not answer"));
  }

  @Test
  void whatIsUnderWayIsToldAsSuch() {
    house.coordinator.submit(
        new GoalRequest(SlParser.formula("(in rose zone-a)"), "Bob"), outcome -> {});
    house.clock.runUntil(() -> house.calls.contains("move rose"), Duration.ofMinutes(1));

    assertThat(plan(1).steps())
        .filteredOn(step -> step.state() == State.UNDER_WAY)
        .singleElement()
        .satisfies(
            step -> {
              assertThat(step.begun()).isPresent();
              assertThat(step.ended()).isEmpty();
            });

    house.coordinator.cancel("G1", "Bob");
    assertThat(plan(1).steps())
        .extracting(StepRecord::state)
        .doesNotContain(State.UNDER_WAY, State.WAITING)
        .contains(State.CALLED_OFF);
  }

  @Test
  void eachStepHasOneWhoWasChosenAndThePricesOfTheOthers() {
    assertThat(house.achieve("(nextTo Cup Bob)").reached()).isTrue();

    PlanRecord plan = plan(1);
    for (StepRecord step : plan.steps()) {
      List<BidRecord> answers =
          plan.bids().stream()
              .filter(bid -> bid.step().equals(OptionalInt.of(step.step().number())))
              .toList();
      assertThat(answers).allMatch(bid -> bid.feature().equals(step.step().feature().name()));
      assertThat(answers)
          .filteredOn(BidRecord::chosen)
          .singleElement()
          .satisfies(
              bid -> {
                assertThat(bid.member()).isEqualTo(step.step().member());
                assertThat(((BidRecord.Priced) bid.answer()).cost())
                    .isEqualTo(OptionalDouble.of(step.step().cost()));
              });
    }
    assertThat(plan.bids()).anyMatch(bid -> bid.step().isPresent() && !bid.chosen());
  }

  @Test
  void whoNamesNoPriceIsToldWithTheReason() {
    house.declines = feature -> feature.equals("move");
    assertThat(house.achieve("(in rose zone-a)").reached()).isFalse();

    assertThat(house.coordinator.plans("G1"))
        .anySatisfy(
            plan -> {
              assertThat(plan.steps()).isEmpty();
              assertThat(plan.bids())
                  .anyMatch(
                      bid ->
                          bid.member().equals("rose")
                              && bid.answer() instanceof BidRecord.Refused refused
                              && refused.reason().contains("it cannot be done now"));
            });
  }

  @Test
  void nothingIsKeptOfAGoalThatThereNeverWas() {
    assertThat(house.coordinator.plans("G9")).isEmpty();
  }
}
