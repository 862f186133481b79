package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;

/** One simulated robot assumes the task that another is at (M43); the goal decides. */
@MaestroTest(home = "bob-two-robots", scene = "bob-two-robots")
class RobotTakeoverTest {

  private static final String WISH = "(nextTo Cup Bob)";

  @Test
  void whoIsLateIsRelieved(Stage stage) {
    stage.world().freeze("rose", 40);
    Pursuit pursuit = stage.begin(WISH).awaitTelling("4 of 7: rose picks up Cup");

    GoalOutcome outcome = pursuit.await();

    assertThat(outcome).isReached().tells("tim offers to do").tells("tim picks up Cup");
    assertThat(stage.world()).hasNextTo("Cup", "Bob").hasPutDown("Cup");
  }
}
