package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.Term;

/** Results that teach nothing are failures, and who goes on giving them is left alone. */
class UselessResultsTest {
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = UselessResultsTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);

  static Stream<Arguments> useless() {
    return Stream.of(
        Arguments.of(
            Map.of("lux", new Term.Text("bright")), "lux has to be a number, and is \"bright\""),
        Arguments.of(
            Map.of("lux", new Term.Number(Double.NaN)), "lux has to be a number, and is NaN"),
        Arguments.of(
            Map.of("lux", new Term.Number(Double.POSITIVE_INFINITY)),
            "lux has to be a number, and is Infinity"),
        Arguments.of(Map.of("lux", new Term.Truth(true)), "lux has to be a number, and is true"),
        Arguments.of(Map.of(), "lux is missing"),
        Arguments.of(Map.of("light", new Term.Number(80)), "lux is missing"));
  }

  @ParameterizedTest
  @MethodSource("useless")
  void areNamedAndEndAfterThree(Map<String, Term> outputs, String named) {
    measurementsAre(outputs);

    GoalOutcome outcome = house.achieve("(>= (illuminance zone-b) 72)");

    assertThat(calls("measureIllumination lux-b")).as(String.join("\n", house.story)).isEqualTo(3);
    assertThat(outcome.reached()).isFalse();
    assertThat(house.story)
        .anyMatch(
            told ->
                told.contains(
                    "That failed: lux-b reports a result that teaches nothing: " + named + "."));
    assertThat(outcome.reasons()).anyMatch(reason -> reason.contains(named));
    assertThat(outcome.reasons()).anyMatch(reason -> reason.contains("not proven"));
  }

  @Test
  void leaveTheFeatureAloneForTheNextGoalTooUntilItsDeviceDescribesItselfAnew() {
    measurementsAre(Map.of());
    house.achieve("(>= (illuminance zone-b) 72)");
    house.achieve("(>= (illuminance zone-b) 72)");
    assertThat(calls("measureIllumination lux-b")).isEqualTo(3);

    house.reporting = (step, report) -> report;
    house.coordinator.memberPresent("lux-b");

    GoalOutcome outcome = house.achieve("(>= (illuminance zone-b) 72)");
    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
  }

  @Test
  void doNotStandInTheWayOfWhatOthersTell() {
    house.ambientLux.put("zone-b", 100.0);
    house.knowledge.state(
        new org.maestro.knowledge.api.Source(
            org.maestro.knowledge.api.Source.Kind.OBSERVED, "lux-b"),
        List.of("(= (illuminance zone-b) 100)"));
    house.place.put("Cup", "zone-b");
    house.reporting =
        (step, report) ->
            step.feature().procedure().equals("observeObject")
                ? new ActionDispatcher.Report(
                    true,
                    Map.of("found", new Term.Truth(true), "pose", new Term.Text("over there")),
                    Optional.empty(),
                    List.of())
                : report;

    GoalOutcome outcome = house.achieve("(exists (?z - Zone) (in Cup ?z))");

    assertThat(calls("observeObject cam-b")).as(String.join("\n", house.story)).isEqualTo(3);
    assertThat(outcome.reached()).isFalse();
    assertThat(house.story)
        .anyMatch(
            told ->
                told.contains(
                    "pose has to be a pose such as \"1.5 2 0.8\", and is \"over there\""));
  }

  private void measurementsAre(Map<String, Term> outputs) {
    house.reporting =
        (step, report) ->
            step.feature().procedure().equals("measureIllumination")
                ? new ActionDispatcher.Report(true, outputs, Optional.empty(), List.of())
                : report;
  }

  private long calls(String call) {
    return house.calls.stream().filter(call::equals).count();
  }
}
