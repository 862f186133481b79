package org.maestro.junit;

import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;

/** How a test with a stage looks: name a home and a scene, state a goal, change the world, ask. */
@MaestroTest(home = "bob", scene = "bob-lit")
class StageExampleTest {

  @Test
  void aCupThatSomebodyTakesAwayIsBroughtAgain(Stage stage) {
    assertThat(stage.goal("(nextTo Cup Bob)")).isReached().isConfirmed().hasCallsAtMost(10);

    stage.world().moveByHand("Cup", new Position(5.2, 2.2, 0));
    Pursuit pursuit = stage.begin("(in Cup zone-a)");

    assertThat(pursuit.await()).isReached();
    assertThat(stage.knowledge()).knows("(in Cup zone-a)").excludes("(in Cup zone-b)");
  }
}
