package org.maestro.coordination.contention;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.rats.time.SteppedClock;

/** Whom many goals without a plan keep from beginning, and for how long. */
class RushTest {
  private static final int MANY = 9;

  private final SteppedClock clock = new SteppedClock();
  private final List<String> free = new ArrayList<>();
  private final Rush rush = new Rush(clock, Runnable::run, free::add);

  private void state(int from, int to) {
    for (int goal = from; goal < to; goal++) {
      rush.planning("G" + goal);
    }
  }

  private void plan(int from, int to) {
    for (int goal = from; goal < to; goal++) {
      rush.planned("G" + goal);
    }
  }

  @Test
  void aFewGoalsHoldNobodyBack() {
    state(0, MANY - 1);
    assertThat(rush.holdsBack("G0")).isFalse();
  }

  @Test
  void ofManyNoneBeginsUntilAllArePlanned() {
    state(0, MANY);
    assertThat(rush.holdsBack("G1")).isTrue();
    assertThat(rush.holdsBack("G0")).isTrue();
    plan(0, MANY - 1);
    assertThat(rush.holdsBack("G2")).isTrue();
    assertThat(free).isEmpty();
    plan(MANY - 1, MANY);
    assertThat(free).containsExactly("G1", "G0", "G2");
    assertThat(rush.holdsBack("G3")).isFalse();
  }

  @Test
  void whoeverComesAgainAfterThatIsARushOfItsOwn() {
    state(0, MANY);
    plan(0, MANY);
    state(MANY, 2 * MANY);
    assertThat(rush.holdsBack("G" + MANY)).isTrue();
    clock.run(Duration.ofSeconds(4));
    assertThat(free).isEmpty();
  }

  @Test
  void itLastsFiveSecondsAtMostAndIsOverAsLongAsAnyIsNotPlanned() {
    state(0, MANY);
    assertThat(rush.holdsBack("G0")).isTrue();
    clock.run(Duration.ofMillis(4_999));
    assertThat(free).isEmpty();
    clock.run(Duration.ofMillis(2));
    assertThat(free).containsExactly("G0");
    plan(0, MANY - 1);
    state(MANY, 3 * MANY);
    assertThat(rush.holdsBack("G9")).isFalse();
  }
}
