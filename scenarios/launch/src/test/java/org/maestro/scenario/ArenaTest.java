package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;

/** The laboratory, whose only light sensor speaks for zones in which it does not stand. */
@MaestroTest(home = "arena", scene = "arena-dark")
class ArenaTest {

  @Test
  void whatTheSensorSaysOfOtherZonesSendsNoCameraLookingInTheDark(Stage stage) {
    assertThat(stage.goal("(nextTo GreenObject RedObject1)"))
        .isReached()
        .neverTells("cam-1 says")
        .neverTells("cam-3 says")
        .hasCallsAtMost(23);
  }
}
