package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.experiment.setting.Setting;
import org.maestro.experiment.setting.Settings;

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
        .as("drove to an occupied place, metres astray, and where it headed last")
        .extracting(
            row -> row.get(13), row -> row.get(14), row -> row.get(15).replaceAll(".*s: ", ""))
        .satisfiesExactly(
            paper ->
                assertThat(paper.toList())
                    .startsWith("true")
                    .endsWith("puts down beside RedObject1, and there is RedObject2"),
            noticing -> assertThat(noticing.toList()).containsExactly("false", "0.000", ""),
            shutters ->
                assertThat(shutters.toList())
                    .containsExactly(
                        "false", "0.000", "puts down beside RedObject1, and there is RedObject1"));
    assertThat(findings.page().html())
        .contains("The second half, red to green (compare figures 10 and 12)");
    assertThat(findings.tables().get("runs").rows())
        .allMatch(row -> row.get(3).equals("true") == row.get(7).isEmpty());
  }

  /**
   * The sun shines into both zones beside the one in the middle: the camera there refuses because
   * of them, and is not asked again while that is so.
   */
  @Test
  void aRefusalForANeighbouringZoneIsNotRepeated() {
    List<Setting> settings = new MoveObject().settings();
    Settings withoutShutters = new Settings(settings, Map.of("world.shutters", "false"));

    MoveRun run =
        MoveRun.carryOut(
            8, 100_008, MoveObject.SECOND, withoutShutters, OptionalDouble.empty(), false);

    List<String> failures =
        run.ending().story().stream()
            .map(StoryEntry::text)
            .filter(text -> text.startsWith("That failed: cam-2"))
            .toList();
    assertThat(failures)
        .singleElement()
        .asString()
        .contains("zone-1 is over-lit, zone-3 is over-lit");
    assertThat(run.ending().replans()).isLessThan(6);
    assertThat(run.failure()).contains("shutter-west").contains("never joined");
    assertThat(
            MovePage.of(
                    new Request(1, 1, withoutShutters, false), List.of(run), List.of(), List.of())
                .html())
        .contains("none was reached")
        .doesNotContain("NaN");
  }
}
