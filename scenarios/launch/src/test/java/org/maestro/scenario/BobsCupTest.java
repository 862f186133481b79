package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.hal.Position;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.ontology.floor.Pose;
import org.maestro.sl.Term;

@MaestroTest(home = "bob", scene = "bob-dark")
class BobsCupTest {
  private static final double NEAR_METRES = 0.2;

  @Test
  void aCupFromADarkRoom(Stage stage) {
    GoalOutcome outcome = stage.goal("(nextTo Cup Bob)");

    assertThat(outcome).isReached().isConfirmed().hasCallsAtMost(14);
    assertThat(stage.world()).hasNextTo("Cup", "Bob");
    assertThat(stage.knowledge()).knows("(and (in Cup zone-a) (nextTo Cup Bob))");
  }

  /**
   * Three-layered architecture, 2 (M13): from the camera that saw it by way of the knowledge to the
   * robot, and back.
   */
  @Test
  void whereTheCupIsKnownToBeFollowsTheCup(Stage stage) {
    assertThat(stage.goal("(canSee ?camera Cup)")).isReached();
    Position seen = known(stage, "Cup");
    assertThat(seen.distance(truth(stage, "Cup"))).isLessThan(NEAR_METRES);

    assertThat(stage.goal("(nextTo Cup Bob)")).isReached().isConfirmed();

    assertThat(known(stage, "Cup").distance(truth(stage, "Cup"))).isLessThan(NEAR_METRES);
    assertThat(known(stage, "Cup").distance(seen)).isGreaterThan(1);
  }

  /**
   * Three-layered architecture, 2 (M18, M19): plans name rooms; the way there is the robot's, which
   * nobody else is told.
   */
  @Test
  void theWayIsTheRobotsOwn(Stage stage) {
    GoalOutcome outcome = stage.goal("(nextTo Cup Bob)");

    assertThat(outcome).isReached().tells("rose drives to zone-a");
    assertThat(stage.world().path("rose")).hasSizeGreaterThan(3);
    Set<StoryEntry.Kind> ofPlans = Set.of(StoryEntry.Kind.PLAN, StoryEntry.Kind.STEP);
    assertThat(outcome.story().stream().filter(entry -> ofPlans.contains(entry.kind())))
        .isNotEmpty()
        .noneMatch(entry -> entry.text().matches(".*\\(-?[0-9.]+ -?[0-9.]+.*"));
  }

  private static Position known(Stage stage, String thing) {
    Term known =
        stage.knowledge().snapshot().value("position", List.of(new Term.Name(thing))).orElseThrow();
    Pose pose = Pose.parse(((Term.Text) known).value());
    return new Position(pose.x(), pose.y(), pose.z());
  }

  private static Position truth(Stage stage, String thing) {
    return stage.world().position(thing).orElseThrow();
  }
}
