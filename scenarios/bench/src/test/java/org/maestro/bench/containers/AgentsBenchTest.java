package org.maestro.bench.containers;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.bench.BenchReport;

/**
 * Many agents in one process: all are made, described and answer, and none takes much room. How
 * soon is measured by {@code ./maestro bench agents}.
 */
@Isolated("it measures the heap of its process")
class AgentsBenchTest {
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
  @Tag("once")
  void tenThousandAgentsFitIntoAProcess() {
    Map<String, BenchReport.Row> rows = rows(10_000);
    assertThat(rows).containsKey("10000 devices described and in use");
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
