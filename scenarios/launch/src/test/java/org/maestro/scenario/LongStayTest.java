package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.assembly.PastDays;
import org.maestro.junit.Stage;

/**
 * A robot looks after somebody who stays somewhere unusually long: ADE's monitor for the elderly
 * (2; A8).
 */
class LongStayTest {
  private static final String QUESTION = "Are you all right?";
  private static final String CALL = "Dave, Grandma does not answer. Please look in the bathroom.";

  @TempDir Path data;

  /** Grandma goes into the bathroom. */
  private EveningStage evening() {
    EveningStage evening =
        EveningStage.of(
            data,
            PastDays.read(""),
            "evening",
            "<#Mia> scene:fault \"at 1 move 7.5 7\" .",
            "<#Grandma> scene:fault \"at 20 move 10.6 1\" .");
    evening.stage().run(Duration.ofMinutes(29));
    assertThat(evening.said(QUESTION)).as("that is usual").isEmpty();
    assertThat(evening.stage().world().zone("rob")).isEqualTo(Optional.of("hallway"));
    evening.awaitSaid(QUESTION);
    assertThat(evening.said(QUESTION).get(0).to()).isEqualTo("Grandma");
    assertThat(evening.stage().world().zone("rob")).isEqualTo(Optional.of("bathroom"));
    return evening;
  }

  @Test
  void whoDoesNotAnswerIsSeenToBySomebody() {
    try (EveningStage evening = evening()) {
      Stage stage = evening.stage();
      stage.run(Duration.ofSeconds(50));
      assertThat(evening.said(CALL)).as("there is time to answer").isEmpty();
      evening.awaitSaid(CALL);
      assertThat(evening.said(CALL).get(0).to()).isEqualTo("livingroom");
    }
  }
}
