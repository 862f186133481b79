package org.maestro.agents.content;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

/** What was told of beliefs, told again later. */
class BeliefWordsTest {

  @Test
  void whatIsToldAgainLaterIsOlderByThenAndElseTheSame() {
    String told =
        "(inform (:truth true) (:binding (:age 7)) (:age 2) (:confidence 1)"
            + " (:because (:fact \"(in Cup zone-b)\") (:age 2) (:confidence 1)))";

    assertThat(Words.print(BeliefWords.later(Words.parse(told).get(0), Duration.ofMillis(1_500))))
        .isEqualTo(told.replace("(:age 2)", "(:age 3.5)"));
  }
}
