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
  void isNotReadFromOtherParameters() {
    assertThat(CostExchange.of(Map.of())).isEmpty();
    assertThat(CostExchange.of(Map.of("feature", "move", "sets", List.of(1)))).isEmpty();
  }
}
