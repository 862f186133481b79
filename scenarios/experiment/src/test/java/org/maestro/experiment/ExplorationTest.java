package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.maestro.experiment.setting.SettingException;

/**
 * Simulated subjects direct the robot, with a stressed voice and with a neutral one (ADE, 4; A50).
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class ExplorationTest {
  private static final int SUCCESS = 3;
  private static final int SECONDS = 4;
  private static final int FAILURE = 7;
  private static final int CONDITION = 8;
  private static final int KAPPA = 9;
  private static final int UTTERANCES = 10;

  /** So slow that the battery is low before they are done. */
  private final Findings findings =
      CarriedOut.findings("exploration", 2, 1, Map.of("subject.delay.mean", "7"));

  private final List<List<String>> runs = rows(findings, "runs");

  private static List<List<String>> rows(Findings findings, String table) {
    return Objects.requireNonNull(findings.tables().get(table)).rows();
  }

  @Test
  void theSameSubjectsDoTheSameInBothConditionsWhereAVoiceChangesNothing() {
    assertThat(runs).hasSize(2 * 5);
    assertThat(doings("affect", "0.000")).isEqualTo(doings("control", "0.000")).hasSize(2);
    assertThat(doings("affect", "0.300")).isNotEqualTo(doings("control", "0.000"));
    assertThat(runs).allMatch(row -> row.get(SUCCESS).equals("true") == row.get(FAILURE).isEmpty());
  }

  private List<String> doings(String condition, String kappa) {
    return runs.stream()
        .filter(row -> row.get(CONDITION).equals(condition) && row.get(KAPPA).equals(kappa))
        .map(row -> row.get(UTTERANCES) + " in " + row.get(SECONDS))
        .toList();
  }

  @Test
  void thePageTellsWhatIsAssumedAndClaimsNothingOfPeople() throws IOException {
    CarriedOut.assertReadable(findings);
    assertThat(findings.page().html())
        .contains("κ is an assumption")
        .contains("both conditions agree within their intervals")
        .contains("Nothing on this page is a statement about people.");
  }

  @Test
  void theVoiceIsStressedAfterTheFirstReportAndInOneConditionAlone() {
    List<List<String>> reports =
        rows(findings, "words").stream()
            .filter(row -> row.get(6).startsWith("My battery is low"))
            .toList();

    assertThat(reports).isNotEmpty();
    for (List<String> report : reports) {
      boolean isFirst = report.get(6).contains("180");
      String expected = report.get(1).equals("affect") ? "stressed" : "neutral";
      assertThat(report.get(5)).as(report.toString()).isEqualTo(isFirst ? "" : expected);
    }
    assertThat(reports).extracting(row -> row.get(5)).contains("", "stressed", "neutral");
  }

  @Test
  void oneConditionCanBeAskedForAlone() {
    assertThat(rows(CarriedOut.findings("exploration", 1, 2, Map.of("affect", "off")), "runs"))
        .extracting(row -> row.get(CONDITION))
        .containsExactly("control");
    assertThatThrownBy(() -> CarriedOut.findings("exploration", 1, 2, Map.of("affect", "loud")))
        .isInstanceOf(SettingException.class)
        .hasMessage("affect is one of on, off, both, not \"loud\".");
  }
}
