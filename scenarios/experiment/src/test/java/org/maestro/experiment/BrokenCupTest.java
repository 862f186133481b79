package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.experiment.drawing.Figure;

/** Three robots, words of the home's own. */
class BrokenCupTest {

  @Test
  void oneInspectsOneCollectsOneVacuums() throws IOException {
    Findings findings = CarriedOut.findings("broken-cup", 1, 1, Map.of());

    CarriedOut.assertReadable(findings);
    assertThat(findings.tables().get("runs").rows()).allMatch(row -> row.get(3).equals("true"));
    assertThat(findings.figures()).extracting(Figure::name).contains("timeline");
    assertThat(findings.tables().get("steps").rows())
        .as("one after the other, each to its end")
        .hasSizeGreaterThan(8)
        .allMatch(row -> row.get(5).equals("true"));
    assertThat(findings.tables().get("deeds").rows())
        .extracting(row -> row.get(2))
        .startsWith("scout")
        .contains("rose")
        .endsWith("dusty");
    assertThat(findings.tables().get("runs").rows())
        .as("replans: where it put the first shard, the robot knows")
        .allMatch(row -> row.get(6).equals("0"));
  }
}
