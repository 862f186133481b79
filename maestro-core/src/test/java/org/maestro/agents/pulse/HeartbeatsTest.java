package org.maestro.agents.pulse;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class HeartbeatsTest {
  private static final HeartbeatSettings SETTINGS =
      new HeartbeatSettings(millis(500), millis(2_000), millis(4_000));

  private final Heartbeats heartbeats = new Heartbeats(SETTINGS, Duration.ZERO);
  private final List<Heartbeats.Change> changes = new ArrayList<>();

  @Test
  void whoIsSilentIsSuspectedThenLost() {
    heartbeats.heard("lights", Duration.ZERO);
    check(0, 6_000);

    assertThat(changes)
        .containsExactly(
            new Heartbeats.Change("lights", Condition.SUSPECTED, millis(2_000)),
            new Heartbeats.Change("lights", Condition.LOST, millis(4_000)));
  }

  @Test
  void whoSpeaksAgainInTimeIsTrusted() {
    heartbeats.heard("lights", Duration.ZERO);
    check(0, 3_000);
    heartbeats.heard("lights", millis(3_200));
    check(3_000, 4_000);

    assertThat(changes)
        .extracting(Heartbeats.Change::now)
        .containsExactly(Condition.SUSPECTED, Condition.ALIVE);
  }

  @Test
  void whoWasLostStaysLostWhateverItSays() {
    heartbeats.heard("lights", Duration.ZERO);
    check(0, 5_000);
    heartbeats.heard("lights", millis(5_100));
    check(5_000, 7_000);

    assertThat(heartbeats.conditions()).containsEntry("lights", Condition.LOST);
    assertThat(changes).hasSize(2);
  }

  /**
   * The process of the watch itself was frozen: it has heard nobody, which says nothing of them.
   */
  @Test
  void whoHasSleptItselfBlamesNobody() {
    heartbeats.heard("lights", Duration.ZERO);
    check(0, 500);
    check(60_000, 60_500);
    assertThat(changes).isEmpty();

    check(60_500, 65_500);
    assertThat(changes)
        .extracting(Heartbeats.Change::now)
        .containsExactly(Condition.SUSPECTED, Condition.LOST);
  }

  @Test
  void whoEndsAsItShouldIsNotMissed() {
    heartbeats.heard("lights", Duration.ZERO);
    heartbeats.forget("lights");
    check(0, 10_000);

    assertThat(changes).isEmpty();
    assertThat(heartbeats.conditions()).isEmpty();
  }

  @Test
  void settingsThatMissALateSignOfLifeAreRefused() {
    assertThatThrownBy(() -> new HeartbeatSettings(millis(500), millis(900), millis(4_000)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("two periods or more");
    assertThatThrownBy(() -> new HeartbeatSettings(millis(500), millis(2_000), millis(2_500)))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void aContainerStopsToActBeforeItIsGivenUp() {
    assertThat(SETTINGS.lease()).isLessThan(SETTINGS.lostAfter());
  }

  private void check(long from, long until) {
    for (long at = from; at <= until; at += 500) {
      changes.addAll(heartbeats.check(millis(at)));
    }
  }

  private static Duration millis(long millis) {
    return Duration.ofMillis(millis);
  }
}
