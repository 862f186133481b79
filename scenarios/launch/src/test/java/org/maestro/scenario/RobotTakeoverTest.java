package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;

/**
 * One simulated robot assumes the task that another is at (Three-layered architecture, 3.2.1; M43);
 * the goal decides.
 */
class RobotTakeoverTest {

  private static final String WISH = "(nextTo Cup Bob)";

  @Nested
  @MaestroTest(home = "bob-two-robots", scene = "bob-two-robots")
  class InTwoRooms {

    @Test
    void whoIsLateIsRelieved(Stage stage) {
      stage.world().freeze("rose", 40);
      Pursuit pursuit = stage.begin(WISH).awaitTelling("4 of 7: rose picks up Cup");

      GoalOutcome outcome = pursuit.await();

      assertThat(outcome).isReached().tells("tim offers to do").tells("tim picks up Cup");
      assertThat(stage.world()).hasNextTo("Cup", "Bob").hasPutDown("Cup");
    }
  }

  /** Both begin in room A, rose nearer to the cup, which is in room C. */
  @Nested
  @MaestroTest(home = "/three-rooms-two-robots.ttl", scene = "/three-rooms-robots-in-a.ttl")
  class WithLongWays {

    @Test
    void whoHasBecomeCheaperTakesOver(Stage stage) {
      stage.world().moveByHand("Bob", new Position(7.2, 2.2, 0));
      Pursuit pursuit = stage.begin(WISH).awaitTelling(": rose drives to zone-c");
      stage.run(Duration.ofMillis(500));
      stage.world().moveByHand("tim", new Position(7.2, 0.6, 0));

      GoalOutcome outcome = pursuit.await();

      assertThat(outcome)
          .isReached()
          .tells("tim offers to do for 0.5 what is left of step")
          .tells("No longer wanted: rose drives to zone-c")
          .tells("tim picks up Cup")
          .neverTells("rose reports: Cup is in rose");
      assertThat(stage.world()).hasNextTo("Cup", "Bob");
    }

    @Test
    void whoseWheelsSlipIsRelieved(Stage stage) {
      Pursuit pursuit = stage.begin(WISH).awaitTelling(": rose drives to zone-c");
      stage.world().slip("rose", 0.9);

      assertThat(pursuit.await())
          .isReached()
          .tells("tim offers to do it")
          .tells("tim picks up Cup")
          .neverTells("rose reports: Cup is in rose");
    }

    /** A drive was priced from where the robot stood before it had picked up the cup. */
    @Test
    void whoHoldsTheThingKeepsItsTaskThoughItTakesLongerThanTold(Stage stage) {
      assertThat(stage.goal("(in tim zone-c)")).isReached();

      assertThat(stage.goal(WISH))
          .isReached()
          .tells("rose offers to do it")
          .tells("tim places Cup at Bob")
          .neverTells("rose reports");
    }
  }
}
