package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;

/** Where no camera looks from the ceiling, a robot goes and looks with its own. */
class SearchingRobotTest {

  private static final String WISH = "(nextTo Cup Bob)";

  @Nested
  @MaestroTest(home = "/three-rooms.ttl", scene = "/three-rooms-cup-in-c.ttl")
  class WithTheCupInTheRoomWithoutCamera {

    @Test
    void theRobotDrivesThereLooksFindsAndFetches(Stage stage) {
      GoalOutcome outcome = stage.goal(WISH);

      assertThat(outcome)
          .isReached()
          .isConfirmed()
          .tells("lamp-c is set to")
          .tells("rose looks around for Cup in zone-c");
      assertThat(stage.world()).hasNextTo("Cup", "Bob");
    }
  }

  @Nested
  @MaestroTest(home = "/three-rooms.ttl", scene = "/three-rooms-hidden.ttl")
  class WithTheCupHidden {

    @Test
    void allThatCanBeLookedAtIsLookedAt(Stage stage) {
      assertThat(stage.goal(WISH))
          .isNotReached()
          .isExplainedBy("Cup was looked for in vain")
          .isExplainedBy("in zone-a by cam-a")
          .isExplainedBy("in zone-c by rose")
          .isExplainedBy("% of it in view");
      assertThat(stage.knowledge())
          .excludes("(or (in Cup zone-a) (in Cup zone-b) (in Cup zone-c))");
    }
  }
}
