package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** One run in the dark, one with the agent that sees to the light. */
class IlluminationTest {

  @Test
  void nothingIsDetectedInTheDarkAndAlmostAllAfterTheAgentRaisedTheLight() throws IOException {
    Findings findings = CarriedOut.findings("illumination", 1, 3, Map.of());

    CarriedOut.assertReadable(findings);
    assertThat(value(findings, "detection rate in the dark")).isLessThan(1);
    assertThat(value(findings, "detection rate above the threshold")).isGreaterThan(95);
    assertThat(findings.tables().get("runs").rows()).allMatch(row -> row.get(3).equals("true"));
    assertThat(findings.page().html()).contains("is set to");
  }

  private static double value(Findings findings, String name) {
    return findings.results().stream()
        .filter(result -> result.name().equals(name))
        .findFirst()
        .orElseThrow()
        .value();
  }
}
