package org.maestro.coordination.lessons;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.Journal;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Term;

class FailureMemoryTest {
  private final FailureMemory memory = new FailureMemory("G1", Journal.none(), step -> 3);
  private final StepKey look =
      new StepKey("cam-b", "observeObject", Map.of("object", new Term.Name("Cup")));

  private void failsWith(String facts) {
    memory.note(look, facts, "It cannot see", List.of(), Optional.empty());
  }

  @Test
  void aStepHasTwoChancesWithTheSameFacts() {
    failsWith("dark");
    assertThat(memory.barred(step -> "dark")).isEmpty();

    failsWith("dark");
    assertThat(memory.barred(step -> "dark"))
        .containsExactly(
            Map.entry(
                look, "it was asked for 2 times with the same facts, in vain: It cannot see"));
  }

  @Test
  void changedFactsGiveANewChance() {
    failsWith("dark");
    failsWith("dark");

    assertThat(memory.barred(step -> "bright")).isEmpty();
  }

  @Test
  void failuresWithOtherFactsDoNotAddUp() {
    failsWith("dark");
    failsWith("dim");

    assertThat(memory.barred(step -> "dim")).isEmpty();
  }

  @Test
  void thereIsOneLastChance() {
    failsWith("dark");
    assertThat(memory.giveLastChances(step -> "dark")).isFalse();
    failsWith("dark");

    assertThat(memory.giveLastChances(step -> "dark")).isTrue();
    assertThat(memory.barred(step -> "dark")).isEmpty();

    failsWith("dark");
    assertThat(memory.barred(step -> "dark")).containsKey(look);
    assertThat(memory.giveLastChances(step -> "dark")).isFalse();
  }
}
