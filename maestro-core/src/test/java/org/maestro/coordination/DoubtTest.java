package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** Who may be lost is not counted on, and no goal is given up for want of it before it is known. */
class DoubtTest {
  private static final String GOAL = "(nextTo Cup Bob)";
  private static final Duration LATER = Duration.ofSeconds(3);

  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = DoubtTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);

  @Test
  void nothingIsAskedOfASuspectedLampThatOthersCanStandInFor() {
    house.coordinator.memberDoubted("lamp-b1", "its container is silent");

    GoalOutcome outcome = house.achieve(GOAL);

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).noneMatch(call -> call.contains("lamp-b1"));
  }

  @Test
  void aGoalWaitsForItsOnlyRobotUntilItIsThereAgain() {
    house.coordinator.memberDoubted("rose", "its container is silent");
    house.clock.schedule(LATER, "test", () -> house.coordinator.memberTrusted("rose"));

    GoalOutcome outcome = house.achieve(GOAL);

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.story).anyMatch(line -> line.contains("it is not given up yet"));
    assertThat(house.story).anyMatch(line -> line.contains("rose is there again"));
  }

  @Test
  void whenTheOnlyRobotIsLostTheGoalFailsAndSaysWhy() {
    house.coordinator.memberDoubted("rose", "its container is silent");
    house.clock.schedule(
        LATER, "test", () -> house.coordinator.memberLost("rose", "nobody can take over"));

    GoalOutcome outcome = house.achieve(GOAL);

    assertThat(outcome.reached()).isFalse();
    assertThat(String.join(" ", outcome.reasons())).contains("nobody can take over");
  }

  /** Its agent falls silent while the robot drives; another agent hears how it went. */
  @Test
  void aPlanIsFollowedOnThoughAMemberWasInDoubtMeanwhile() {
    house.ambientLux.put("zone-b", 100.0);
    house.beforeCall =
        call -> {
          if (call.equals("pick rose")) {
            house.coordinator.memberDoubted("rose", "it is getting another agent");
            house.clock.schedule(
                Duration.ofMillis(200), "test", () -> house.coordinator.memberPresent("rose"));
          }
        };

    GoalOutcome outcome = house.achieve(GOAL);

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).filteredOn(call -> call.equals("pick rose")).hasSize(1);
  }
}
