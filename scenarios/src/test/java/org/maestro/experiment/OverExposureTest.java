package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Map;
import org.junit.jupiter.api.Test;

/** One run in clear sunshine under each condition. */
class OverExposureTest {

  @Test
  void shuttersLetTheRunSucceedThatIsClaimedFalselyWithoutThem() throws IOException {
    Findings findings =
        CarriedOut.findings(
            "over-exposure", 1, 1, Map.of("world.clouds", "0", "world.clouds.change", "0"));

    CarriedOut.assertReadable(findings);
    assertThat(findings.tables().get("runs").rows())
        .as("condition, success, false claim")
        .extracting(row -> row.get(8) + " " + row.get(3) + " " + row.get(11))
        .containsExactly("paper false true", "noticing false false", "shutters true false");
    assertThat(findings.tables().get("runs").rows())
        .allMatch(row -> row.get(3).equals("true") == row.get(7).isEmpty());
  }
}
