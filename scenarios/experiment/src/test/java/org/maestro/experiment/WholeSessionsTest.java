package org.maestro.experiment;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.experiment.drawing.Figure;

/**
 * Experiments with as many runs as the papers report, or more (Three-layered architecture, 5.2 and
 * 6; M93, M94, M96, M98).
 */
@Tag("full")
@Tag("once")
class WholeSessionsTest {
  private static final String PAPER = "cameras do not notice, as in the paper: ";
  private static final String NOTICING = "cameras notice: ";
  private static final String SHUTTERS = "cameras notice, and shutters: ";
  private static final String PAPER_SECOND =
      "cameras do not notice, as in the paper, red to green: ";
  private static final String SHUTTERS_SECOND = "cameras notice, and shutters, red to green: ";

  @Test
  void twentyRunsReachTheirGoalInLittleMoreThanTheLeastTime() {
    Findings findings = CarriedOut.findings("move-object", 20, 1, Map.of());

    assertThat(value(findings, "reached, in the simulated world")).isEqualTo(20);
    assertThat(value(findings, "claims that were not so")).isZero();
    assertThat(value(findings, "time over its physical lower bound, mean")).isBetween(1.0, 1.1);
    List<List<String>> rows = findings.tables().get("runs").rows();
    assertThat(findings.page().html())
        .as("mean and deviation in seconds")
        .containsPattern("<td>time of a run</td><td>[^<]*</td><td>\\d+\\.\\d s ± \\d+\\.\\d s ");
    assertThat(rows.subList(0, 10)).allMatch(row -> row.get(2).equals(MoveObject.FIRST.goal()));
    assertThat(rows.subList(10, 20)).allMatch(row -> row.get(2).equals(MoveObject.SECOND.goal()));
  }

  @Test
  void inTheSunCamerasThatNoticeClaimNothingFalseAndShuttersHelp() {
    Findings findings =
        CarriedOut.findings(
            "over-exposure", 10, 1, Map.of("world.clouds", "0", "world.clouds.change", "0"));

    assertThat(value(findings, PAPER + "claims what is not so")).isPositive();
    assertThat(value(findings, NOTICING + "claims what is not so")).isZero();
    assertThat(value(findings, SHUTTERS + "claims what is not so")).isZero();
    assertThat(value(findings, SHUTTERS + "reached")).isEqualTo(10);
    assertThat(findings.tables().get("runs").rows())
        .as("replans")
        .allMatch(row -> Integer.parseInt(row.get(6)) < 10);
  }

  /**
   * Within fifty minutes of a clear morning, in which the sun comes to shine on the things. As the
   * paper tells it (M94), the first ten runs are consistent, and in some of the second ten the
   * robot takes the wrong thing or heads for a place that another one occupies. Later in the day
   * the cameras recognise nothing any more.
   */
  @Test
  void theFirstTenRunsAreConsistentAndInTheSecondTenTheRobotHeadsForAnOccupiedPlace() {
    Findings findings =
        CarriedOut.findings(
            "over-exposure",
            20,
            1,
            Map.of(
                "world.clouds", "0",
                "world.clouds.change", "0",
                "world.sun.start", "9.3",
                "world.sun.minutes", "2.5"));

    List<List<String>> asInThePaper =
        findings.tables().get("runs").rows().stream()
            .filter(row -> row.get(8).equals("paper"))
            .toList();
    assertThat(asInThePaper).hasSize(20);
    assertThat(asInThePaper.subList(0, 10))
        .as("the first half: reached, and claimed truly")
        .allMatch(row -> row.get(3).equals("true") && row.get(11).equals("false"));
    assertThat(value(findings, PAPER_SECOND + "runs")).isEqualTo(10);
    assertThat(value(findings, PAPER_SECOND + "the wrong thing was taken")).isPositive();
    assertThat(value(findings, PAPER_SECOND + "drove to an occupied place")).isPositive();
    assertThat(value(findings, PAPER_SECOND + "strayed")).isPositive();
    assertThat(value(findings, SHUTTERS + "reached")).isEqualTo(20);
    assertThat(value(findings, SHUTTERS_SECOND + "drove to an occupied place")).isZero();
    assertThat(value(findings, SHUTTERS_SECOND + "strayed")).isZero();
    assertThat(findings.figures())
        .extracting(Figure::name)
        .contains("paper-heat-red-to-green", "shutters-heat-red-to-green");
  }

  @Test
  void ofFiftyGoalsPlanningAgainReachesMoreThanAFixedPlan() {
    Findings findings = CarriedOut.findings("join-leave", 50, 1, Map.of());

    assertThat(value(findings, "undisturbed: reached")).isEqualTo(50);
    assertThat(value(findings, "planning again: reached"))
        .isGreaterThan(value(findings, "fixed plan: reached"));
    assertThat(value(findings, "claims that were not so")).isZero();
    assertThat(findings.tables().get("runs").rows())
        .as("each failure is explained")
        .allMatch(row -> row.get(3).equals("true") == row.get(7).isEmpty());
  }

  private static double value(Findings findings, String name) {
    return findings.results().stream()
        .filter(result -> result.name().equals(name))
        .findFirst()
        .orElseThrow()
        .value();
  }
}
