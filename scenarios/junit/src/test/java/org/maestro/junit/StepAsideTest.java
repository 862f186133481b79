package org.maestro.junit;

import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.assertj.core.api.Assertions;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;

/** Who stands in a robot's way is asked to step aside, where the home has a rule for it. */
@MaestroTest(home = "evening", scene = "evening")
class StepAsideTest {
  private static final Position IN_THE_DOOR = new Position(10.6, 4, 0);
  private static final Position BESIDE = new Position(4.5, 4.8, 0);
  private static final String PLEASE = "Excuse me, Dave, please let Rob pass.";

  @Test
  void whoStandsInADoorIsAskedAndTheGoalIsReachedOnceHeHasMadeWay(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("hallway");
    stage.run(Duration.ofSeconds(2));
    stage.world().moveByHand("Dave", IN_THE_DOOR);

    Pursuit pursuit = stage.begin("(in rob bathroom)");
    dave.awaits(PLEASE);
    assertThat(stage.knowledge()).knows("(inTheWayOf Dave rob)").knows("(waitedFor rob)");
    stage.world().moveByHand("Dave", BESIDE);

    assertThat(pursuit.await()).isReached();
    stage.run(Duration.ofSeconds(10));
    assertThat(stage.knowledge()).excludes("(inTheWayOf Dave rob)").knows("(not (waitedFor rob))");
  }

  @Test
  void whoDoesNotMakeWayIsAskedOnceAndThenItIsSaidWhoStandsThere(Stage stage) {
    List<String> said = new CopyOnWriteArrayList<>();
    stage.platform().desk().whenSaid(speech -> said.add(speech.text()));
    stage.run(Duration.ofSeconds(2));
    stage.world().moveByHand("Dave", IN_THE_DOOR);

    assertThat(stage.goal("(in rob bathroom)")).isNotReached().isExplainedBy("Dave stands in it");
    stage.run(Duration.ofMinutes(1));
    assertThat(stage.knowledge()).knows("(not (waitedFor rob))");
    Assertions.assertThat(said).containsExactly(PLEASE);
  }

  @Test
  void whoIsInNobodysWayIsAskedNothing(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("hallway");
    stage.run(Duration.ofSeconds(2));
    stage.world().moveByHand("Dave", IN_THE_DOOR);

    assertThat(stage.goal("(in rob kitchen)")).isReached();

    dave.hasHeardNothing();
  }
}
