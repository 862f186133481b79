package org.maestro.bench;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.SceneLoader;

/** Memory stands still, however many goals a platform has pursued. */
@Isolated("what others beside it have in the heap would be measured, too")
@Tag("full")
class SoakBenchTest {
  private static final double MOST_MIB_FOR_100_GOALS = 0.5;

  private static InputStream stream(String resource) {
    return SoakBenchTest.class.getResourceAsStream(resource);
  }

  @Test
  void aThousandGoalsLeaveLessThanHalfAMebibyteForEachHundred() throws IOException {
    Home bob =
        new HomeLoader()
            .load(new String(stream("/homes/bob.ttl").readAllBytes(), UTF_8), "bob.ttl");
    Map<String, Double> figures =
        new SoakBench(
                bob,
                SceneLoader.load("bob-dark", stream("/scenes/bob-dark.ttl"), bob),
                1_000,
                line -> {})
            .run().rows().stream()
                .collect(Collectors.toMap(BenchReport.Row::name, BenchReport.Row::value));

    assertThat(figures.get("goals reached")).isGreaterThan(500);
    assertThat(figures.get("goals held, and then cancelled")).isEqualTo(100);
    assertThat(figures.get("growth of the live heap for 100 goals"))
        .isLessThan(MOST_MIB_FOR_100_GOALS);
  }
}
