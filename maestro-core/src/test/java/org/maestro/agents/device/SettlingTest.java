package org.maestro.agents.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.rats.time.SteppedClock;

class SettlingTest {
  private final SteppedClock clock = new SteppedClock();
  private final List<String> done = new ArrayList<>();
  private boolean ready;

  @Test
  void whoHasJustBegunAnswersWhenItHasHeardOfItsMembers() {
    Settling settling = settling(Settling.LONGEST);
    settling.once(() -> done.add("priced at " + clock.now().toMillis()));
    clock.schedule(Duration.ofMillis(120), "member", () -> ready = true);
    pass(Duration.ofSeconds(5));

    assertThat(done).containsExactly("priced at 150");
  }

  @Test
  void whoseMembersAreNotThereSaysSoAfterAWhile() {
    Settling settling = settling(Settling.LONGEST);
    settling.once(() -> done.add("refused at " + clock.now().toMillis()));
    pass(Duration.ofSeconds(5));

    assertThat(done).containsExactly("refused at 3000");
    assertThat(settling.isOver()).isTrue();
  }

  @Test
  void whoseMembersAreThereAnswersAtOnce() {
    ready = true;
    settling(Settling.LONGEST).once(() -> done.add("priced"));

    assertThat(done).containsExactly("priced");
  }

  /** As on a stepped clock, where nobody comes late. */
  @Test
  void withoutTimeForItNothingWaits() {
    settling(Duration.ZERO).once(() -> done.add("refused"));

    assertThat(done).containsExactly("refused");
  }

  private Settling settling(Duration longest) {
    return new Settling(clock, longest, () -> ready, Runnable::run);
  }

  private void pass(Duration duration) {
    boolean[] passed = {false};
    clock.schedule(duration, "test", () -> passed[0] = true);
    clock.runUntil(() -> passed[0], duration.plusSeconds(1));
  }
}
