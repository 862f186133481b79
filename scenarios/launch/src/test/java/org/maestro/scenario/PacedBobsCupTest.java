package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.junit.ClockKind;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;

/** The job itself over MQTT and in wall time. */
@Isolated("its time is wall time, which others beside it would take")
@MaestroTest(home = "bob", scene = "bob-dark", clock = ClockKind.PACED, speed = 4)
class PacedBobsCupTest {

  @Test
  void bringsTheCup(Stage stage) {
    assertThat(stage.goal("(nextTo Cup Bob)")).isReached().hasCallsAtMost(16);
    assertThat(stage.world()).hasNextTo("Cup", "Bob");
  }
}
