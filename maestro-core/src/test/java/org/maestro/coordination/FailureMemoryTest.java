package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.planning.StepKey;
import org.maestro.sl.Term;

class FailureMemoryTest {
  private final FailureMemory memory = new FailureMemory();
  private final StepKey look =
      new StepKey("cam-b", "observeObject", Map.of("object", new Term.Name("Cup")));

  @Test
  void aStepHasTwoChancesWithTheSameFacts() {
    memory.note(look, "dark");
    assertThat(memory.barred(step -> "dark")).isEmpty();

    memory.note(look, "dark");
    assertThat(memory.barred(step -> "dark")).containsExactly(look);
  }

  @Test
  void changedFactsGiveANewChance() {
    memory.note(look, "dark");
    memory.note(look, "dark");

    assertThat(memory.barred(step -> "bright")).isEmpty();
  }

  @Test
  void failuresWithOtherFactsDoNotAddUp() {
    memory.note(look, "dark");
    memory.note(look, "dim");

    assertThat(memory.barred(step -> "dim")).isEmpty();
  }
}
