package org.maestro.rats.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class CostExchangeTest {

  private final CostExchange exchange =
      new CostExchange("move", List.of(Map.of("to", "zone-a"), Map.of("to", "zone-b")));

  @Test
  void goesThereAndBack() {
    assertThat(CostExchange.of(exchange.parameters())).contains(exchange);
    List<CostAnswer> answers =
        List.of(
            new CostAnswer(Optional.of(4.0), Optional.of(3.5), Optional.empty()),
            new CostAnswer(Optional.empty(), Optional.empty(), Optional.of("no way there")));
    assertThat(exchange.answers(CostExchange.values(answers))).isEqualTo(answers);
  }

  @Test
  void answersEverySetEvenWhenTheMemberDidNot() {
    assertThat(exchange.answers(Map.of()))
        .hasSize(2)
        .allMatch(answer -> answer.cost().isEmpty() && answer.reason().isPresent());
    assertThat(exchange.refused("lost")).hasSize(2).allMatch(answer -> answer.reason().isPresent());
  }

  @Test
  void takesWhatAResultSaysForItsAnswers() {
    CostAnswer price = new CostAnswer(Optional.of(4.0), Optional.of(3.5), Optional.empty());
    assertThat(
            exchange.answers(
                result(Outcome.SUCCEEDED, CostExchange.values(List.of(price)), Optional.empty())))
        .containsExactly(
            price, CostAnswer.unanswered("the member gave no answer for this parameter set"));
  }

  @Test
  void isDeclinedOnlyByAMemberThatRejectsIt() {
    RatsError error =
        new RatsError(
            ErrorCode.DISABLED,
            RatsError.Level.ERROR,
            "not now",
            Optional.empty(),
            List.of(),
            false);
    CostAnswer declined =
        new CostAnswer(Optional.empty(), Optional.empty(), Optional.of("not now"));
    for (Outcome outcome : Outcome.values()) {
      if (outcome != Outcome.SUCCEEDED) {
        CostAnswer each = outcome == Outcome.REJECTED ? declined : CostAnswer.unanswered("not now");
        assertThat(exchange.answers(result(outcome, Map.of(), Optional.of(error))))
            .as(outcome.name())
            .containsExactly(each, each);
      }
    }
    assertThat(exchange.answers(result(Outcome.FAILED, Map.of(), Optional.empty())))
        .containsOnly(CostAnswer.unanswered("no reason given"));
  }

  @Test
  void isNotReadFromOtherParameters() {
    assertThat(CostExchange.of(Map.of())).isEmpty();
    assertThat(CostExchange.of(Map.of("feature", "move", "sets", List.of(1)))).isEmpty();
  }

  private static Result result(
      Outcome outcome, Map<String, Object> values, Optional<RatsError> error) {
    return new Result("c1", "rose", outcome, "on", values, error);
  }
}
