package org.maestro.bench.containers;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.bench.BenchReport;

/** Goals end, though processes with containers are killed while they are pursued. */
@Isolated("its time is wall time, which others beside it would take")
@Tag("full")
class ContainersBenchTest {

  @Test
  void tenGoalsEndThoughOneOfTwoProcessesIsKilled() {
    Map<String, Double> figures = figures(2, 2, 10);
    assertThat(figures).containsEntry("goals ended", 10.0);
    assertThat(figures).containsEntry("processes killed meanwhile", 1.0);
  }

  @Test
  @Tag("once")
  void aThousandGoalsEndThoughTwoOfTwentyProcessesAreKilled() {
    Map<String, Double> figures = figures(20, 200, 1_000);
    assertThat(figures).containsEntry("agents in other processes", 200.0);
    assertThat(figures).containsEntry("goals ended", 1_000.0);
    assertThat(figures).containsEntry("processes killed meanwhile", 2.0);
  }

  private static Map<String, Double> figures(int processes, int containers, int goals) {
    Function<BenchReport.Row, String> name = BenchReport.Row::name;
    return new ContainersBench(processes, containers, goals, 1, line -> {})
        .run().rows().stream().collect(Collectors.toMap(name, BenchReport.Row::value));
  }
}
