package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.api.Step;
import org.maestro.sl.Term;

/**
 * What only its doer says is never plainly reached, and not at all when a sensor says otherwise.
 */
class SeenNotSaidTest {
  private PretendHouse house;
  private double amount;
  private boolean shut;

  @BeforeEach
  void furnish() throws IOException {
    try (InputStream turtle = SeenNotSaidTest.class.getResourceAsStream("/workshop.ttl")) {
      house =
          new PretendHouse(
              new HomeLoader()
                  .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "workshop.ttl"));
    }
    amount = 20;
    shut = false;
    house.made.put(
        "fill pump-1",
        step -> {
          amount = 100;
          return PretendHouse.succeeded(Map.of());
        });
    house.made.put("restock pump-1", step -> PretendHouse.succeeded(Map.of()));
    house.made.put(
        "shutHatch motor-1",
        step -> {
          shut = true;
          return PretendHouse.succeeded(Map.of());
        });
    house.made.put(
        "openHatch motor-1",
        step -> {
          shut = false;
          return PretendHouse.succeeded(Map.of());
        });
    house.made.put("seal motor-1", step -> PretendHouse.succeeded(Map.of()));
    house.made.put(
        "gauge gauge-1", step -> PretendHouse.succeeded(Map.of("amount", new Term.Number(amount))));
    house.made.put(
        "inspect eye-1", step -> PretendHouse.succeeded(Map.of("shut", new Term.Truth(shut))));
    state("gauge-1", Source.Kind.OBSERVED, "(= (amount Barrel) 20)");
  }

  @Test
  void aNumberIsMeasuredByWhoDidNotMakeIt() {
    GoalOutcome outcome = achieve("(>= (amount Barrel) 95)");

    assertConfirmed(outcome);
    assertThat(house.calls).endsWith("fill pump-1", "gauge gauge-1");
  }

  @Test
  void aPredicateIsLookedAtByWhoDidNotMakeIt() {
    GoalOutcome outcome = achieve("(shut Lid)");

    assertConfirmed(outcome);
    assertThat(house.calls).endsWith("shutHatch motor-1", "inspect eye-1");
  }

  @Test
  void whatIsNotToBeSoIsLookedAtToo() {
    shut = true;
    state("eye-1", Source.Kind.OBSERVED, "(shut Lid)");

    GoalOutcome outcome = achieve("(not (shut Lid))");

    assertConfirmed(outcome);
    assertThat(house.calls).endsWith("openHatch motor-1", "inspect eye-1");
  }

  @Test
  void whatNobodyCanLookAtIsSaidToBeSoOnlyAsFarAsItsDoerSays() {
    for (String goal : List.of("(sealed Lid)", "(>= (stock Barrel) 40)")) {
      GoalOutcome outcome = achieve(goal);

      assertThat(outcome.reached()).as(story()).isTrue();
      assertThat(outcome.confirmed()).as(story()).isFalse();
      assertThat(outcome.reasons().get(0)).contains("-1 says", "nobody can confirm it");
    }
  }

  @Test
  void whatWasSaidForAnEarlierGoalIsNotSeenThereby() {
    achieve("(sealed Lid)");

    GoalOutcome outcome = achieve("(sealed Lid)");

    assertThat(outcome.confirmed()).as(story()).isFalse();
    assertThat(outcome.calls()).isZero();
  }

  @Test
  void whatIsDerivedRestsOnWhatItIsDerivedFrom() {
    GoalOutcome outcome = achieve("(safe Lid)");

    assertThat(outcome.reached()).as(story()).isTrue();
    assertThat(outcome.confirmed()).as(story()).isFalse();
    assertThat(house.calls).contains("inspect eye-1");
  }

  @Test
  void aDoersOwnStateIsItsWordToo() {
    house.made.put(
        "fill pump-1",
        step -> {
          amount = 80;
          house.knowledge.state(
              new Source(Source.Kind.STATED, "pump-1"), List.of("(= (amount Barrel) 97)"));
          return PretendHouse.succeeded(Map.of());
        });

    GoalOutcome outcome = achieve("(>= (amount Barrel) 95)");

    assertThat(outcome.reached()).as(story()).isFalse();
    assertThat(house.calls).contains("gauge gauge-1");
  }

  @Test
  void whoeverOnlySaysThatItIsDoneIsFoundOut() {
    house.made.put("shutHatch motor-1", step -> PretendHouse.succeeded(Map.of()));

    GoalOutcome outcome = achieve("(shut Lid)");

    assertThat(outcome.reached()).as(story()).isFalse();
  }

  @Test
  void aSensorThatIsLessSureIsNotOutvotedByTheDoer() throws IOException {
    try (InputStream turtle = SeenNotSaidTest.class.getResourceAsStream("/workshop.ttl")) {
      String unsure =
          new String(turtle.readAllBytes(), StandardCharsets.UTF_8)
              + "home:gauge-1 maestro:confidence 0.4 .";
      Map<String, Function<Step, ActionDispatcher.Report>> made = house.made;
      house = new PretendHouse(new HomeLoader().load(unsure, "workshop.ttl"));
      house.made.putAll(made);
    }
    house.made.put(
        "fill pump-1",
        step -> {
          amount = 80;
          return PretendHouse.succeeded(Map.of());
        });
    state("gauge-1", Source.Kind.OBSERVED, "(= (amount Barrel) 20)");

    GoalOutcome outcome = achieve("(>= (amount Barrel) 95)");

    assertThat(outcome.reached()).as(story()).isFalse();
  }

  @Test
  void aStateThatSaysNoBeatsAResultThatSaysYes() {
    house.made.put(
        "restock pump-1",
        step -> {
          later(() -> state("pump-1", Source.Kind.STATED, "(= (stock Barrel) 0)"));
          return PretendHouse.succeeded(Map.of());
        });
    house.made.put(
        "seal motor-1",
        step -> {
          later(() -> state("motor-1", Source.Kind.STATED, "(not (sealed Lid))"));
          return PretendHouse.succeeded(Map.of());
        });

    for (String goal : List.of("(>= (stock Barrel) 80)", "(and (sealed Lid) (shut Lid))")) {
      GoalOutcome outcome = achieve(goal);

      assertThat(outcome.reached()).as(story()).isFalse();
    }
    assertThat(house.calls).filteredOn("restock pump-1"::equals).hasSizeLessThan(8);
    assertThat(house.calls).filteredOn("seal motor-1"::equals).hasSizeLessThan(6);
  }

  @Test
  void whatIsSaidToBeDoneInVainIsNotDoneForEver() {
    house.made.put("fill pump-1", step -> PretendHouse.succeeded(Map.of()));

    GoalOutcome outcome = achieve("(>= (amount Barrel) 95)");

    assertThat(outcome.reached()).as(story()).isFalse();
    assertThat(String.join(" ", outcome.reasons())).contains("not proven to be impossible");
    assertThat(house.calls).filteredOn("fill pump-1"::equals).hasSizeLessThan(6);
  }

  @Test
  void whoTellsOfItsOwnAccordIsListenedTo() {
    state("lid-watch", Source.Kind.STATED, "(not (sealed Lid))");
    house.made.put(
        "seal motor-1",
        step -> {
          house.clock.schedule(
              Duration.ofSeconds(2),
              "lid-watch",
              () -> state("lid-watch", Source.Kind.STATED, "(sealed Lid)"));
          return PretendHouse.succeeded(Map.of());
        });

    assertConfirmed(achieve("(sealed Lid)"));
  }

  @Test
  void whoWouldTellOfItsOwnAccordAndDoesNotIsBelieved() {
    state("lid-watch", Source.Kind.STATED, "(not (sealed Lid))");

    GoalOutcome outcome = achieve("(sealed Lid)");

    assertThat(outcome.reached()).as(story()).isFalse();
    assertThat(String.join(" ", outcome.reasons())).contains("lid-watch");
  }

  private void later(Runnable saying) {
    house.clock.schedule(Duration.ofMillis(1), "state", saying);
  }

  private GoalOutcome achieve(String goal) {
    return house.achieve(goal);
  }

  private String story() {
    return String.join("\n", house.story);
  }

  private void assertConfirmed(GoalOutcome outcome) {
    assertThat(outcome.reached()).as(story()).isTrue();
    assertThat(outcome.confirmed()).as(story()).isTrue();
  }

  private void state(String member, Source.Kind kind, String fact) {
    house.knowledge.state(new Source(kind, member), List.of(fact));
  }
}
