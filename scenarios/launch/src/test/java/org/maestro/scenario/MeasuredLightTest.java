package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;

/**
 * A goal of light is reached when it is measured, not when it is reckoned (Three-layered
 * architecture, 1; M5).
 */
@MaestroTest(home = "bob", scene = "bob-weak-lamps")
class MeasuredLightTest {

  @Test
  void weakLampsAreNotTakenAtTheirWord(Stage stage) {
    GoalOutcome outcome = stage.goal("(>= (illuminance zone-b) 72)");

    assertThat(outcome)
        .isReached()
        .isConfirmed()
        .tells("it is to be measured: the illuminance of zone-b");
    assertThat(stage.world()).hasLuxAtLeast("zone-b", 72);
  }

  @Test
  void lightWhereAThingIsIsMeasuredToo(Stage stage) {
    GoalOutcome outcome =
        stage.goal("(exists (?z - Zone) (and (in rose ?z) (>= (illuminance ?z) 70)))");

    assertThat(outcome).isReached().isConfirmed();
  }
}
