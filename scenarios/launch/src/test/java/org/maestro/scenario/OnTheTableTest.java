package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;

/** What lies on something is seen by where it is, and a robot puts things on tables. */
@MaestroTest(home = "evening", scene = "glasses")
class OnTheTableTest {

  @Test
  void theGlassFromTheFloorIsPutOnTheCounter(Stage stage) {
    GoalOutcome outcome = stage.goal("(on glass-2 counter-1)");

    assertThat(outcome).isReached().tells("rob puts glass-2 on counter-1");
    assertThat(stage.world().position("glass-2").orElseThrow().z()).isEqualTo(0.9);
    assertThat(stage.knowledge()).knows("(on glass-2 counter-1)");
  }

  @Test
  void whatACameraSeesIsKnownToLieOnTheTable(Stage stage) {
    assertThat(stage.goal("(canSee cam-kitchen glass-1)")).isReached();

    assertThat(stage.knowledge()).knows("(on glass-1 table-1)");
    assertThat(stage.knowledge()).excludes("(on glass-1 floor-k)");
  }
}
