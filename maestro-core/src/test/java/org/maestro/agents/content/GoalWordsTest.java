package org.maestro.agents.content;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.Stakes;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.api.Worth;
import org.maestro.sl.SlParser;

class GoalWordsTest {

  @Test
  void readsPriorityAndDeadline() {
    GoalRequest request = request("(initCNP (:goal (in Cup A)) (:priority 5) (:deadline 60))");

    assertThat(request.priority()).isEqualTo(5);
    assertThat(request.deadline()).contains(Duration.ofSeconds(70));
  }

  @Test
  void bothMayBeLeftOut() {
    assertThat(request("(initCNP (:goal (in Cup A)))"))
        .isEqualTo(new GoalRequest(SlParser.formula("(in Cup A)"), "Bob"));
  }

  @Test
  void saysWhatIsNoPriorityAndNoDeadline() {
    for (String words : List.of("(:priority high)", "(:priority 0.5)", "(:deadline soon)")) {
      assertThatThrownBy(() -> request("(initCNP (:goal (in Cup A)) " + words + ")"))
          .isInstanceOf(InvalidGoalException.class)
          .hasMessageContaining("write");
    }
    assertThatThrownBy(() -> request("(initCNP (:goal (in Cup A)) (:deadline -1))"))
        .hasMessageContaining("over before");
    assertThatThrownBy(() -> request("(initCNP (:goal (in Cup A)) (:deadline 1e16))"))
        .hasMessageContaining("more than ten years away");
  }

  @Test
  void readsWhatItIsWorth() {
    assertThat(request("(initCNP (:goal (in Cup A)) (:benefit 60))").stakes())
        .contains(new Stakes(SlParser.expression("60")));
    assertThat(
            request(
                    Words.print(
                        new AskedGoal("(in Cup A)")
                            .stakes(
                                new AskedStakes(
                                    Optional.of("(+ 40 (level lamp-a1))"),
                                    Optional.of(0.5),
                                    Optional.of(600.0),
                                    Optional.of(2.0),
                                    Optional.of(4.0)))
                            .content()))
                .stakes())
        .contains(
            new Stakes(
                SlParser.expression("(+ 40 (level lamp-a1))"),
                0.5,
                Optional.of(Duration.ofMinutes(10)),
                2,
                4));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(:chance 0.5) | nothing without a benefit",
        "(:allowed 60) | nothing without a benefit",
        "(:benefit \"(+ 40\") | The benefit is no number",
        "(:benefit much) | The benefit is no number",
        "(:benefit 60) (:chance 1.5) | not from 0 to 1",
        "(:benefit 60) (:chance good) | is no number",
        "(:benefit 60) (:allowed 0) | not between 0 s and ten years",
        "(:benefit 60) (:urgency 1) | needs two numbers above 0",
        "(:benefit 60) (:urgency 5 1) | needs two numbers above 0",
        "(:benefit 60) (:urgency 0 1) | needs two numbers above 0",
      })
  void saysWhatIsWrongWithItsWorth(String words, String sentence) {
    assertThatThrownBy(() -> request("(initCNP (:goal (in Cup A)) " + words + ")"))
        .isInstanceOf(InvalidGoalException.class)
        .hasMessageContaining(sentence);
  }

  @Test
  void tellsWhatAGoalIsWorth() {
    Worth worth =
        new Worth(
            0.8,
            3,
            OptionalDouble.of(60),
            14,
            Duration.ofSeconds(60),
            Optional.of(Duration.ofSeconds(600)),
            1,
            10);
    GoalStatus status =
        new GoalStatus(
                "G2",
                "(in Cup A)",
                "Bob",
                GoalState.RUNNING,
                "",
                0,
                Optional.empty(),
                Duration.ofSeconds(60),
                List.of())
            .worth(Optional.of(worth))
            .stakes(
                Optional.of(
                    new Stakes(SlParser.expression("(+ 40 20)")).allowed(Duration.ofSeconds(600))));

    assertThat(Words.print(GoalWords.status(status)))
        .contains("(:worth (:chance 0.8) (:tried 3) (:benefit 60) (:cost 14) (:utility 34)")
        .contains("(:elapsed 60) (:allowed 600) (:from 1) (:to 10) (:urgency 1.9) (:priority 64.6)")
        .contains(
            "(:stakes (:benefit \"(+ 40 20)\") (:chance 0.8) (:allowed 600) (:urgency 1 10))");
  }

  @Test
  void tellsWhatAGoalWaitsFor() {
    WaitsFor edge = new WaitsFor("G2", Resource.component("rose", "base"), "G1");
    GoalStatus status =
        new GoalStatus(
            "G2",
            "(in Cup A)",
            "Bob",
            GoalState.WAITING,
            edge.inWords(),
            3,
            Optional.of(Duration.ofSeconds(9)),
            Duration.ofSeconds(4),
            List.of(edge));

    assertThat(Words.print(GoalWords.status(status)))
        .contains("(:state waiting)", "(:priority 3)", "(:deadline 9)", "(:age 4)")
        .contains("(:waits (:for \"the base of rose\" G1))");
    assertThat(Words.print(GoalWords.wait(edge)))
        .isEqualTo(
            "(inform (:goal G2) (:kind component) (:for \"the base of rose\") (:holder G1))");
  }

  private static GoalRequest request(String text) {
    return GoalWords.request(
        SlParser.formula("(in Cup A)"),
        "Bob",
        Words.of(Words.parse(text).get(0)),
        Duration.ofSeconds(10));
  }
}
