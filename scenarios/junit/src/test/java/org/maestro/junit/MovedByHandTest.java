package org.maestro.junit;

import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;

/** What was moved while nobody looked is not claimed to be where it was seen last. */
@MaestroTest(home = "bob", scene = "bob-lit")
class MovedByHandTest {
  private static final Position IN_ROOM_B = new Position(5.2, 2.2, 0);

  @Test
  void whatWasBroughtAndTakenAwayIsBroughtAgain(Stage stage) {
    assertThat(stage.goal("(nextTo Cup Bob)")).isReached();
    stage.world().moveByHand("Cup", IN_ROOM_B);
    stage.run(Duration.ofMinutes(5));

    assertThat(stage.goal("(nextTo Cup Bob)")).isReached().isConfirmed();

    assertThat(stage.world()).hasNextTo("Cup", "Bob");
  }
}
