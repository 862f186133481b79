package org.maestro.agents.content;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalState;
import org.maestro.sl.Term;

class GoalReportTest {

  @Test
  void readsTheAnswerOfTheCca() {
    GoalReport report =
        GoalReport.read(
            "(inform (:goal G1 (canSee cam-b Cup)) (:binding (:agent cam-b)) (:state achieved)"
                + " (:confirmed true) (:reasons) (:calls 6) (:replans 2) (:seconds 12.5)"
                + " (:decision-ms 40))");

    assertThat(report.id()).contains("G1");
    assertThat(report.reached()).isTrue();
    assertThat(report.confirmed()).isTrue();
    assertThat(report.binding()).isEqualTo(Map.of("agent", new Term.Name("cam-b")));
    assertThat(report.calls()).isEqualTo(6);
    assertThat(report.duration()).isEqualTo(Duration.ofMillis(12_500));
  }

  @Test
  void aRefusalKeepsItsSentence() {
    GoalReport report = GoalReport.read("(inform (:reason \"Nobody knows Mug.\"))");

    assertThat(report.id()).isEmpty();
    assertThat(report.state()).isEqualTo(GoalState.FAILED);
    assertThat(report.reasons()).containsExactly("Nobody knows Mug.");
  }
}
