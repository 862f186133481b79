package org.maestro.agents.content;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.WaitsFor;
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
