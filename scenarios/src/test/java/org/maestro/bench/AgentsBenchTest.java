package org.maestro.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Many agents in one process: all are made, described and answer. */
class AgentsBenchTest {
  /** What is asked for is 5 s on Java 25; a machine that does other things is given more. */
  private static final double MADE_WITHIN_SECONDS = 20;

  private static final double MOST_KIBIBYTES = 40;

  @Test
  void aHundredAgentsAreMadeDescribedAndAsked() {
    Map<String, BenchReport.Row> rows = rows(100);
    assertThat(rows)
        .containsKeys("100 agents made, platform and all", "100 devices described and in use");
    assertThat(rows.get("question and answer, described, p50").value()).isPositive();
  }

  @Test
  @Tag("full")
  void tenThousandAgentsFitIntoAProcess() {
    Map<String, BenchReport.Row> rows = rows(10_000);
    assertThat(rows.get("10000 agents made, platform and all").value())
        .isLessThan(MADE_WITHIN_SECONDS);
    assertThat(rows.get("heap of each").value()).isBetween(1.0, MOST_KIBIBYTES);
    assertThat(rows.get("heap of each, described, with all that is known of it").value())
        .isBetween(1.0, MOST_KIBIBYTES);
  }

  private static Map<String, BenchReport.Row> rows(int agents) {
    return new AgentsBench(agents, line -> {})
        .run().rows().stream()
            .collect(Collectors.toMap(BenchReport.Row::name, Function.identity()));
  }
}
