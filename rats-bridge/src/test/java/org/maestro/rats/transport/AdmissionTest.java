package org.maestro.rats.transport;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class AdmissionTest {
  private final Admission admission = new Admission();
  private final List<Integer> admitted = new ArrayList<>();

  @Test
  void letsFewInAtATimeAndTheOthersInTheirOrder() {
    IntStream.range(0, 100).forEach(number -> admission.enter(() -> admitted.add(number)));
    assertThat(admitted).hasSize(16);
    admission.leave();
    assertThat(admitted).hasSize(17);
    IntStream.range(0, 83).forEach(left -> admission.leave());
    assertThat(admitted).isEqualTo(IntStream.range(0, 100).boxed().toList());
  }

  @Test
  void letsInAnewWhoeverLeftRoom() {
    for (int number = 0; number < 1_000; number++) {
      int one = number;
      admission.enter(() -> admitted.add(one));
      admission.leave();
    }
    assertThat(admitted).hasSize(1_000);
  }

  @Test
  void doesNotGoDeeperWithEachThatLeavesAtOnce() {
    for (int number = 0; number < 16; number++) {
      admission.enter(() -> {});
    }
    for (int number = 0; number < 100_000; number++) {
      int one = number;
      admission.enter(
          () -> {
            admitted.add(one);
            admission.leave();
          });
    }
    admission.leave();
    assertThat(admitted).hasSize(100_000);
  }
}
