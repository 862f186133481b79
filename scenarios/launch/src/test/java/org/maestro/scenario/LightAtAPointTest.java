package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.world.World;

/**
 * What is wanted at a point is asked for by its coordinates (Three-layered architecture, 1; M5).
 */
@MaestroTest(home = "bob", scene = "bob-dark")
class LightAtAPointTest {
  private static final Position IN_THE_DARK = new Position(4.1, 1.5, 0.8);
  private static final String LIT = "(>= (illuminance (at 4.1 1.5 0.8)) 120)";

  @Test
  void aRobotInTheDarkAsksForLightAtAPointAndTheNearestLampLightsAndNoOther() {
    String wish = "maestro:pursues \"%s\" ; :speed 0.8".formatted(LIT);
    try (Stage stage = Stage.stepped(OwnAccordTest.site("point", "", ":speed 0.8", wish))) {
      assertThat(stage.world().lux(IN_THE_DARK)).isLessThan(20);

      stage.await("it is light there", () -> stage.world().lux(IN_THE_DARK) >= 120);

      onlyTheNearestIsLit(stage.world());
    }
  }

  @Test
  void lightAtAPointIsMeasuredAndThePointGoesWithTheGoal(Stage stage) {
    GoalOutcome outcome = stage.goal(LIT);

    assertThat(outcome)
        .isReached()
        .isConfirmed()
        .tells("it is to be measured: the illuminance of (4.1 1.5 0.8)");
    assertThat(stage.world().lux(IN_THE_DARK)).isGreaterThanOrEqualTo(120);
    onlyTheNearestIsLit(stage.world());
    assertThat(stage.knowledge().home().individuals()).doesNotContainKey("at_4.1_1.5_0.8");
  }

  @Test
  void aCupIsBroughtToAPoint(Stage stage) {
    GoalOutcome outcome = stage.goal("(nextTo Cup (at 4.5 0.8))");

    assertThat(outcome).isReached().tells("rose places Cup at (4.5 0.8 0)");
    assertThat(stage.world().position("Cup").orElseThrow().floor().distance(new Point2(4.5, 0.8)))
        .isLessThanOrEqualTo(0.6);
  }

  @Test
  void aPointOutsideIsRefused(Stage stage) {
    GoalOutcome outcome = stage.goal("(nextTo Cup (at 9 0.8))");

    assertThat(outcome.reached()).isFalse();
    assertThat(outcome.explanation())
        .contains("The goal names (at 9 0.8 0), which lies outside of all zones");
  }

  private static void onlyTheNearestIsLit(World world) {
    assertThat(world.lampLevel("lamp-b1")).as("straight above").isEqualTo(1);
    assertThat(world.lampLevel("lamp-b2")).as("0.8 m off").isZero();
    assertThat(world.lampLevel("lamp-b3")).as("0.6 m off").isZero();
  }
}
