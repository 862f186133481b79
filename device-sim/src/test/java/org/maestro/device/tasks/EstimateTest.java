package org.maestro.device.tasks;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.rats.member.Execution;
import org.maestro.rats.protocol.CostAnswer;

/** What a routine would take, told to who asks why not, and to who does not. */
class EstimateTest {

  private int searches;

  private final class Barred extends DeviceProcedure {
    @Override
    void start(Execution execution, CallParameters parameters) {
      throw new AssertionError("Nothing was begun.");
    }

    @Override
    Estimate cost(CallParameters parameters) {
      return parameters.number("share") > 0
          ? price(2, 500)
          : impossible(
              () -> {
                searches++;
                return "there is no free way";
              });
    }
  }

  @Test
  void theReasonIsSearchedForOnlyWhereItIsTold() {
    Barred barred = new Barred();

    assertThat(barred.costIfAble(Map.of("share", 0))).isEmpty();
    assertThat(searches).isZero();
    assertThat(barred.cost(Map.of("share", 0)).reason()).contains("there is no free way");
    assertThat(searches).isEqualTo(1);
  }

  @Test
  void bothAreToldTheSameAmount() {
    CostAnswer answer = new Barred().cost(Map.of("share", 1));

    assertThat(answer.cost()).contains(2.5);
    assertThat(new Barred().costIfAble(Map.of("share", 1))).contains(answer);
  }

  @Test
  void faultyParametersAreNoStackTrace() {
    assertThat(new Barred().costIfAble(Map.of())).isEmpty();
    assertThat(new Barred().cost(Map.of()).reason()).isPresent();
  }
}
