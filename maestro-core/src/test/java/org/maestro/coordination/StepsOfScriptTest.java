package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ScriptStep;
import org.maestro.coordination.contention.ResourceClaimsTest;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.sl.SlParser;

/** Each step of a script is told as data: done, under way, to come. */
class StepsOfScriptTest {
  private static final Duration LIMIT = Duration.ofMinutes(10);
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    home = ResourceClaimsTest.narrowHome();
  }

  private static NarrowHouse house(String body) {
    Script script = new Script("tidy", List.of(), SlParser.body(body, home.vocabulary()::isFluent));
    return new NarrowHouse(home.withScripts(Map.of("tidy", script)), 1)
        .with("rose", "zone-a")
        .with("Cup", "zone-b");
  }

  private static List<String> steps(NarrowHouse house) {
    return house.coordinator.stepsOfScript("G1").stream()
        .map(step -> "%s %s %s".formatted(step.path(), step.state(), step.text()))
        .toList();
  }

  @Test
  void whatIsUnderWayStandsBetweenWhatIsDoneAndWhatIsToCome() {
    NarrowHouse house =
        house(
            "(seq (do move rose :to zone-b) (par (do pick rose :object Cup) (wait 3))"
                + " (if (in rose zone-a) (fail \"x\") (do move rose :to zone-c)))");
    house.wish("(tidy)");
    house.clock.runUntil(() -> house.calls.contains("pick rose"), LIMIT);

    assertThat(steps(house))
        .containsExactly(
            "1 DONE (do move rose :to zone-b)",
            "2 UNDER_WAY (par …)",
            "2.1 UNDER_WAY (do pick rose :object Cup)",
            "2.2 UNDER_WAY (wait 3)",
            "3 WAITING (if (in rose zone-a) …)",
            "3.1 WAITING (fail \"x\")",
            "3.2 WAITING else (do move rose :to zone-c)");

    assertThat(house.run(1, LIMIT)).isTrue();
    assertThat(steps(house))
        .contains("3 DONE (if (in rose zone-a) …)", "3.1 DROPPED (fail \"x\")")
        .contains("3.2 DONE else (do move rose :to zone-c)");
    assertThat(house.coordinator.stepsOfScript("G1"))
        .filteredOn(step -> step.ended().isPresent())
        .hasSize(6)
        .allMatch(step -> step.begun().orElseThrow().compareTo(step.ended().orElseThrow()) <= 0);
  }

  @Test
  void whatWentWrongIsToldWhereItDid() {
    NarrowHouse house =
        house(
            "(seq (try (fail \"no cup\") (recover \"cup\" (fail \"no mug\"))"
                + " (finally (wait 1))) (wait 5))");
    house.wish("(tidy)");
    house.run(1, LIMIT);

    assertThat(steps(house))
        .containsExactly(
            "1 FAILED (try …)",
            "1.1 FAILED (fail \"no cup\")",
            "1.3 FAILED recover \"cup\" (fail \"no mug\")",
            "1.2 DONE finally (wait 1)",
            "2 DROPPED (wait 5)");
    assertThat(house.coordinator.stepsOfScript("G1"))
        .filteredOn(step -> step.path().equals("1"))
        .extracting(ScriptStep::problem)
        .containsExactly(Optional.of("no mug"));
  }

  @Test
  void ofALoopTheLatestRoundIsTold() {
    NarrowHouse house =
        house("(seq (foreach (?z - Zone) (= 1 1) (seq (wait 1) (wait 2))) (wait 3))");
    house.wish("(tidy)");
    house.clock.runUntil(() -> steps(house).contains("1.3.1 UNDER_WAY (wait 1)"), LIMIT);

    assertThat(steps(house))
        .containsExactly(
            "1 UNDER_WAY (foreach (?z - Zone) (= 1 1) …)",
            "1.3 UNDER_WAY (seq …)",
            "1.3.1 UNDER_WAY (wait 1)",
            "1.3.2 WAITING (wait 2)",
            "2 WAITING (wait 3)");
  }

  @Test
  void whatIsCancelledNeverBegins() {
    NarrowHouse house = house("(seq (try (wait 60) (finally (wait 1))) (wait 5))");
    house.wish("(tidy)");
    house.clock.runUntil(() -> steps(house).contains("1.1 UNDER_WAY (wait 60)"), LIMIT);
    house.coordinator.cancel("G1", "Bob");
    house.run(1, LIMIT);

    assertThat(steps(house))
        .containsExactly(
            "1 CALLED_OFF (try …)",
            "1.1 CALLED_OFF (wait 60)",
            "1.2 DONE finally (wait 1)",
            "2 DROPPED (wait 5)");
  }
}
