package org.maestro.bench;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/** Scripts that wait, and scripts side by side, all come to their ends. */
@Isolated("its time is wall time, which others beside it would take")
@Tag("full")
class ScriptsBenchTest {

  @Test
  void allIsMeasuredBesidePlainGoals() {
    BenchReport report = new ScriptsBench(30, 4, line -> {}).run();

    assertThat(report.rows())
        .hasSize(7)
        .allSatisfy(
            row -> {
              assertThat(row.value()).isPositive();
              assertThat(row.baseline()).isPresent();
            });
  }
}
