package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class JoinLeaveTest {

  @Test
  void oneGoalEachWay() throws IOException {
    Findings findings = CarriedOut.findings("join-leave", 1, 1, Map.of());

    CarriedOut.assertReadable(findings);
    assertThat(findings.tables().get("runs").rows())
        .extracting(row -> row.get(8))
        .containsExactly("undisturbed", "replanning", "fixed_plan");
    assertThat(findings.tables().get("runs").rows())
        .allMatch(row -> row.get(3).equals("true") == row.get(7).isEmpty());
  }

  @Test
  void whoComesAndGoesDependsOnTheSeedAlone() {
    List<String> robots = List.of("first", "second");
    List<String> others = List.of("lamp", "camera");

    assertThat(Comings.drawn(5, robots, others)).isEqualTo(Comings.drawn(5, robots, others));
    assertThat(Comings.drawn(5, robots, others)).isNotEqualTo(Comings.drawn(6, robots, others));
  }
}
