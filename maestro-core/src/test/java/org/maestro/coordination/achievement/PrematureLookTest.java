package org.maestro.coordination.achievement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.Household;
import org.maestro.planning.api.Step;

/** A look that was begun before what it looks at is changed shows nothing of that change. */
class PrematureLookTest {
  private static final Step OPENS = step(1, "(open door-1)");
  private static final Step LOOKS = step(2, "(sense (open door-1))");

  @Test
  void aLookAfterTheChangeOfWhatItLooksAtIsBegunAnew() {
    assertThat(PrematureLook.isIn(List.of(OPENS, LOOKS), LOOKS)).isTrue();
  }

  @Test
  void aLookBeforeItGoesOn() {
    assertThat(PrematureLook.isIn(List.of(LOOKS, OPENS), LOOKS)).isFalse();
  }

  @Test
  void soDoesALookAtSomethingElseAndWhatIsNoLook() {
    Step elsewhere = step(2, "(sense (open door-2))");

    assertThat(PrematureLook.isIn(List.of(OPENS, elsewhere), elsewhere)).isFalse();
    assertThat(PrematureLook.isIn(List.of(LOOKS, OPENS), OPENS)).isFalse();
  }

  private static Step step(int number, String effect) {
    return new Step(number, "rose", Household.feature(effect, ""), Map.of(), 1, 1, true, Set.of());
  }
}
