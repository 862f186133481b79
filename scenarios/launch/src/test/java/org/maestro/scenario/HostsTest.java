package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.maestro.bench.BenchReport;
import org.maestro.bench.losses.Loss;
import org.maestro.bench.losses.LossesBench;

/**
 * Bob's cup with agents on hosts that have addresses of their own: a host is killed, freezes, is
 * cut off for ten seconds, or is slow, and all hosts but the platform's own are lost; and a letter
 * is stamped though the platform's process is lost (ADE, 3 and 3.2; A18, A32, A33, A34, A37). The
 * goal is reached, no agent is there twice, and no step is done twice. How often each is run is
 * told by the property {@code maestro.hosts.runs}; what was measured goes to the output.
 */
@Tag("full")
@Isolated("its time is wall time, which others beside it would take")
class HostsTest {

  @ParameterizedTest
  @EnumSource(Loss.class)
  void theGoalIsReachedThough(Loss loss) {
    assumeTrue(
        LossesBench.isPossible(loss),
        "No network namespaces can be made here (ip netns, as root; .ci/run installs iproute2):"
            + " no link can be lost.");
    int runs = Integer.getInteger("maestro.hosts.runs", 1);
    Map<String, Double> figures =
        new LossesBench(List.of(loss), runs, System.out::println)
            .run().rows().stream()
                .collect(Collectors.toMap(BenchReport.Row::name, BenchReport.Row::value));
    String prefix = loss.inWords() + ": ";
    assertThat(figures.keySet()).as("what was measured").anyMatch(name -> name.startsWith(prefix));
    if (loss == Loss.KILLED || loss == Loss.FROZEN) {
      assertThat(figures.get(prefix + "noticed after, worst")).isLessThan(5);
      assertThat(figures.get(prefix + "agent back, from then, worst")).isLessThan(3);
    } else if (loss == Loss.MAIN) {
      assertThat(figures.get(prefix + "platform answers again after, worst")).isLessThan(5);
    }
  }
}
