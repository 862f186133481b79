package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.HomeLoader;

/** A goal that is so by a surer source, while a less sure one has said otherwise since. */
class DisputedGoalTest {
  private static final String IN_A = "(position Cup \"1.5 1.5 0\")";
  private static final String ELSEWHERE_IN_A = "(position Cup \"1.6 1.5 0\")";
  private static final String IN_B = "(position Cup \"4.5 1.5 0\")";

  private PretendHouse house;

  @BeforeEach
  void furnish() throws IOException {
    String home =
        Files.readString(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"));
    house =
        new PretendHouse(
            new HomeLoader().load(home + "\nhome:cam-b maestro:confidence 0.6 .\n", "bob.ttl"));
    house.ambientLux.put("zone-a", 100.0);
    house.ambientLux.put("zone-b", 100.0);
    house.place.put("Cup", "zone-a");
    see("cam-a", IN_A);
    house.clock.run(Duration.ofSeconds(1));
  }

  @Test
  void itIsLookedAtAgain() {
    see("cam-b", IN_B);

    GoalOutcome outcome = house.achieve("(in Cup zone-a)");

    assertThat(outcome.confirmed()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).endsWith("observeObject cam-a");
  }

  @Test
  void whoWasRightIsBelieved() {
    see("cam-b", IN_B);
    house.place.put("Cup", "zone-b");

    GoalOutcome outcome = house.achieve("(in Cup zone-a)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.place).containsEntry("Cup", "zone-a");
    assertThat(house.calls).contains("pick rose");
  }

  @Test
  void whatAnotherSaysThatDoesNotContradictTheGoalNeedsNoLook() {
    see("cam-b", ELSEWHERE_IN_A);

    assertThat(house.achieve("(in Cup zone-a)").confirmed()).isTrue();
    assertThat(house.calls).isEmpty();
  }

  @Test
  void whoSaysOtherwiseIsNamedWhenNobodyCanLookAgain() {
    see("cam-b", IN_B);
    house.coordinator.memberLost("cam-a", "no power");
    see("cam-a", IN_A);
    house.clock.run(Duration.ofSeconds(1));
    see("cam-b", IN_B);

    GoalOutcome outcome = house.achieve("(in Cup zone-a)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.confirmed()).isFalse();
    assertThat(outcome.reasons().get(0)).contains("not certain", "cam-b has said since");
  }

  private void see(String camera, String fact) {
    house.knowledge.state(new Source(Source.Kind.OBSERVED, camera), List.of(fact));
  }
}
