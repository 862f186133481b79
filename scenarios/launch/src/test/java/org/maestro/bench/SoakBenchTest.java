package org.maestro.bench;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.launch.JavaProcess;

/** Memory stands still, however many goals a platform has pursued. */
@Tag("full")
@Tag("once")
class SoakBenchTest {
  private static final Duration LIMIT = Duration.ofMinutes(40);
  private static final double MOST_MIB_FOR_100_GOALS = 0.35;

  /** Code is compiled once, but on a busy machine not as soon: it is the most of what is left. */
  private static final double MOST_RESIDENT_MIB_FOR_100_GOALS = 1;

  /** The system counts a page of the heap when it is touched first: all of them at once. */
  private static final String WHOLE_HEAP = "-Xms256m -Xmx256m -XX:+AlwaysPreTouch";

  @Test
  void theSecondThousandOfGoalsLeavesLittle() throws Exception {
    Map<String, Double> figures = new HashMap<>();
    try (JavaProcess soak =
        JavaProcess.start(
            "org.maestro.launch.Maestro",
            List.of("bench", "soak", "--goals", "2000", "--json"),
            Map.of("JDK_JAVA_OPTIONS", WHOLE_HEAP))) {
      JavaProcess.Ended ended = soak.await(LIMIT);
      assertThat(ended.exitCode()).as(ended.errors()).isZero();
      rows(ended.output())
          .forEach(row -> figures.put(row.get("name").asText(), row.get("value").asDouble()));
    }
    assertThat(figures.get("goals reached")).isGreaterThan(1000);
    assertThat(figures.get("goals held, and then cancelled")).isEqualTo(200);
    assertThat(figures.get("growth of the live heap for 100 goals"))
        .isLessThan(MOST_MIB_FOR_100_GOALS);
    assertThat(figures.get("growth of what is resident for 100 goals"))
        .isLessThan(MOST_RESIDENT_MIB_FOR_100_GOALS);
    assertThat(figures.get("growth of the rest of what is resident for 100 goals"))
        .isLessThan(MOST_MIB_FOR_100_GOALS);
  }

  private static JsonNode rows(String report) throws IOException {
    return new ObjectMapper().readTree(report).get("rows");
  }
}
