package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;

/** A room with what any room has, of one file (A71). */
@MaestroTest(home = "parlour", scene = "parlour")
class ParlourTest {

  @Test
  void howWarmItIsIsAskedAndSet(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("parlour");
    dave.says("how warm is it in the parlour?")
        .means("(query-ref (:value (temperature parlour)))")
        .replies("19.02 °C.");
    dave.says("set the temperature to 22 degrees").isReached();

    stage.run(Duration.ofHours(3));

    assertThat(stage.world().celsius("parlour")).isBetween(21.7, 22.3);
    dave.says("is the parlour warmer than 21 degrees?")
        .means("(query-if (> (temperature parlour) 21))")
        .replies("Yes.");
  }
}
