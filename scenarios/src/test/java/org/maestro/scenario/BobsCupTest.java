package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;

@MaestroTest(home = "bob", scene = "bob-dark")
class BobsCupTest {

  @Test
  void aCupFromADarkRoom(Stage stage) {
    GoalOutcome outcome = stage.goal("(nextTo Cup Bob)");

    assertThat(outcome).isReached().isConfirmed().hasCallsAtMost(14);
    assertThat(stage.world()).hasNextTo("Cup", "Bob");
    assertThat(stage.knowledge()).knows("(and (in Cup zone-a) (nextTo Cup Bob))");
  }
}
