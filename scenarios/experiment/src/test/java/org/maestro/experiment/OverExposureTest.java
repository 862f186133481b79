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

/** A run of each half in clear sunshine, under each condition (M94, M96). */
class OverExposureTest {

  @Test
  void shuttersLetTheRunsSucceedInWhichTheWrongThingIsTakenWithoutThem() throws IOException {
    Findings findings =
        CarriedOut.findings(
            "over-exposure", 2, 1, Map.of("world.clouds", "0", "world.clouds.change", "0"));

    CarriedOut.assertReadable(findings);
    List<List<String>> runs = findings.tables().get("runs").rows();
    assertThat(runs)
        .as("condition, goal, success, false claim")
        .extracting(row -> String.join(" ", row.get(8), row.get(2), row.get(3), row.get(11)))
        .containsExactly(
            "paper (nextTo GreenObject RedObject1) false true",
            "paper (nextTo RedObject1 GreenObject) false false",
            "noticing (nextTo GreenObject RedObject1) false false",
            "noticing (nextTo RedObject1 GreenObject) false false",
            "shutters (nextTo GreenObject RedObject1) true false",
            "shutters (nextTo RedObject1 GreenObject) true false");
    assertThat(runs)
        .as("what was carried, whether it drove to an occupied place, and where it headed")
        .extracting(
            row ->
                String.join(
                    " ", row.get(12), row.get(13), row.get(15).replaceAll("[\\d.]+ s: ", "")))
        .satisfiesExactly(
            toRed ->
                assertThat(toRed)
                    .startsWith("GreenObject true")
                    .endsWith("puts down beside RedObject1, and there is RedObject2"),
            toGreen ->
                assertThat(toGreen)
                    .startsWith("RedObject2 true grasps RedObject1, and there is RedObject2"),
            noticing -> assertThat(noticing).isEqualTo(" false "),
            noticing -> assertThat(noticing).isEqualTo(" false "),
            toRed ->
                assertThat(toRed)
                    .startsWith("GreenObject false")
                    .endsWith("puts down beside RedObject1, and there is RedObject1"),
            toGreen ->
                assertThat(toGreen)
                    .startsWith("RedObject1 false")
                    .endsWith("puts down beside GreenObject, and there is GreenObject"));
    assertThat(runs)
        .as("metres astray")
        .extracting(row -> Double.parseDouble(row.get(14)) > 0.5)
        .containsExactly(true, true, false, false, false, false);
    assertThat(findings.page().html())
        .contains("The second half, red to green (compare figures 10 and 12)");
    assertThat(runs).allMatch(row -> row.get(3).equals("true") == row.get(7).isEmpty());
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
