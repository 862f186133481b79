package org.maestro.platform.guard;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ReplayWindowTest {
  private final ReplayWindow window = new ReplayWindow();

  @Test
  void eachNumberComesOnceHoweverTheyOvertakeEachOther() {
    Random chance = new Random(7);
    Set<Long> come = new HashSet<>();
    long base = 1;
    for (int n = 0; n < 50_000; n++) {
      base += chance.nextInt(3);
      long number = Math.max(1, base - chance.nextInt(ReplayWindow.WIDTH / 2));
      assertThat(window.come("a", number)).isEqualTo(come.add(number));
    }
  }

  @Test
  void whatIsTooOldCountsAsCome() {
    assertThat(window.come("a", 1)).isTrue();
    assertThat(window.come("a", 10L * ReplayWindow.WIDTH)).isTrue();
    assertThat(window.come("a", 2)).isFalse();
    assertThat(window.come("a", 9L * ReplayWindow.WIDTH + 1)).isTrue();
    assertThat(window.come("b", 2)).isTrue();
    assertThat(window.come("b", 0)).isFalse();
    assertThat(window.come("b", -ReplayWindow.WIDTH)).isFalse();
  }

  @Test
  void whatCouldNotBeDeliveredMayComeAgain() {
    assertThat(window.come("a", 5)).isTrue();
    window.undo("a", 5);
    assertThat(window.come("a", 5)).isTrue();
    assertThat(window.come("a", 5)).isFalse();
    window.undo("nobody", 5);
  }
}
