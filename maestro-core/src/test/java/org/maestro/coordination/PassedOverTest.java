package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** Who says nothing, and is passed over for that, may be at it still: it is told to end it. */
class PassedOverTest {
  private static final Duration TO_END = Duration.ofSeconds(20);
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = PassedOverTest.class.getResourceAsStream("/greeters.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "greeters.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);
  private final List<ActionDispatcher.Request> orders = new ArrayList<>();
  private final List<Duration> times = new ArrayList<>();

  @BeforeEach
  void theUsherGreetsWithoutAWord() {
    for (String greeter : List.of("usher", "butler")) {
      house.coordinator.memberPresent(greeter, Optional.of("b1@CCA"));
      house.made.put("guide " + greeter, step -> PretendHouse.succeeded(Map.of()));
    }
    house.made.put("greet butler", step -> PretendHouse.succeeded(Map.of()));
    house.made.put("greet usher", step -> unanswered());
    Duration usual = house.stepTakes;
    house.ordered =
        order -> {
          orders.add(order);
          times.add(house.clock.now());
          house.stepTakes = order.ends() ? TO_END : usual;
        };
  }

  @Test
  void itIsToldToEndWhatItHasNotAnsweredAndNotAskedAnew() {
    GoalOutcome outcome = house.achieve("(greeted Bob)");

    assertThat(outcome.reached()).as(story()).isTrue();
    assertThat(ending().call()).isEqualTo(orders.get(0).call());
    assertThat(orders).filteredOn(ActionDispatcher.Request::ends).hasSize(1);
    assertThat(orders).anyMatch(order -> order.step().member().equals("butler"));
    assertThat(house.clock.now().minus(times.get(orders.indexOf(ending()))))
        .as("nobody waits for that when the goal is reached")
        .isLessThan(TO_END);
    assertThat(house.story)
        .anyMatch(
            told ->
                told.contains(
                    "usher has not said what became of it, and is told to end it: usher greets"
                        + " Bob."));
  }

  @Test
  void untilThenNothingElseIsBegunWithItForTheSameGoal() {
    house.made.put("guide butler", step -> refused());

    GoalOutcome outcome = house.achieve("(and (greeted Bob) (guided Bob))");

    assertThat(outcome.reached()).as(story()).isTrue();
    assertThatItEndedFirst();
  }

  @Test
  void norForAnotherGoal() {
    house.made.put("guide butler", step -> refused());
    assertThat(house.achieve("(greeted Bob)").reached()).isTrue();

    GoalOutcome outcome = house.achieve("(guided Bob)");

    assertThat(outcome.reached()).as(story()).isTrue();
    assertThatItEndedFirst();
    assertThat(orders).last().matches(order -> order.step().member().equals("usher"));
  }

  private void assertThatItEndedFirst() {
    int told = orders.indexOf(ending());
    for (int number = told + 1; number < orders.size(); number++) {
      if (orders.get(number).step().member().equals("usher")) {
        assertThat(times.get(number))
            .as(story())
            .isGreaterThanOrEqualTo(times.get(told).plus(TO_END));
      }
    }
  }

  @Test
  void whatItDidAllTheSameCounts() {
    house.made.put("greet butler", step -> refused());
    house.made.put(
        "greet usher",
        step ->
            orders.stream().anyMatch(ActionDispatcher.Request::ends)
                ? PretendHouse.succeeded(Map.of())
                : unanswered());
    house.ordered = orders::add;

    GoalOutcome outcome = house.achieve("(greeted Bob)");

    assertThat(outcome.reached()).as(story()).isTrue();
    assertThat(orders).last().matches(order -> order.step().member().equals("butler"));
  }

  /** Nobody waits for that any more. */
  @Test
  void whatHasNoAnswerWhenTheGoalIsOverIsEndedToo() {
    house.made.put("greet butler", step -> refused());

    GoalOutcome outcome = house.achieve("(greeted Bob)");

    assertThat(outcome.reached()).isFalse();
    ActionDispatcher.Request last = orders.get(orders.size() - 1);
    assertThat(last.step().member()).as(story()).isEqualTo("usher");
    assertThat(house.calledOff).containsExactly(last.call().orElseThrow().id());
  }

  private ActionDispatcher.Request ending() {
    return orders.stream().filter(ActionDispatcher.Request::ends).findFirst().orElseThrow();
  }

  private String story() {
    return String.join("\n", house.story);
  }

  private static ActionDispatcher.Report unanswered() {
    return new ActionDispatcher.Report(
        false,
        Map.of(),
        Optional.of("usher gave no answer in time"),
        List.of(),
        true,
        Optional.empty(),
        true);
  }

  private static ActionDispatcher.Report refused() {
    return new ActionDispatcher.Report(
        false,
        Map.of(),
        Optional.of("the butler is hoarse"),
        List.of(),
        false,
        Optional.of(ActionDispatcher.Refusal.AS_THINGS_ARE),
        false);
  }
}
