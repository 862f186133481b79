package org.maestro.agents.pulse;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class HeartbeatsTest {
  private static final HeartbeatSettings SETTINGS =
      new HeartbeatSettings(millis(500), millis(2_000), millis(4_000));

  private final Heartbeats heartbeats = new Heartbeats(SETTINGS, "main", Duration.ZERO);
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

  /** Its clock runs, but what brings signs of life to it, its own included, gets no time. */
  @Test
  void whoDoesNotHearItselfBlamesNobody() {
    heartbeats.heard("main", Duration.ZERO);
    heartbeats.heard("lights", Duration.ZERO);
    check(0, 30_000);
    assertThat(changes).isEmpty();

    for (long at = 30_500; at <= 36_000; at += 500) {
      heartbeats.heard("main", millis(at));
      changes.addAll(heartbeats.check(millis(at)));
    }
    assertThat(changes)
        .extracting(Heartbeats.Change::name, Heartbeats.Change::now)
        .containsExactly(tuple("lights", Condition.SUSPECTED), tuple("lights", Condition.LOST));
  }

  /** Twenty processes on two cores: whoever listens, or the network, is slow. */
  @Test
  void whereMostAreSlowNobodyIsGivenUpForIt() {
    List<String> slow = List.of("a", "b", "c", "d");
    for (long at = 0; at <= 30_000; at += 500) {
      long pauses = at < 6_000 ? 1_500 : 3_500;
      if (at % pauses == 0) {
        for (String name : slow) {
          heartbeats.heard(name, millis(at));
        }
      }
      changes.addAll(heartbeats.check(millis(at)));
    }

    assertThat(changes).extracting(Heartbeats.Change::now).doesNotContain(Condition.LOST);
    changes.clear();
    check(30_500, 31_000);
    assertThat(changes).isEmpty();
  }

  /** One that is slow among others that are not has itself to blame. */
  @Test
  void oneThatIsSlowAmongOthersIsSuspected() {
    for (long at = 0; at <= 9_000; at += 500) {
      heartbeats.heard("a", millis(at));
      heartbeats.heard("b", millis(at));
      if (at % 3_000 == 0) {
        heartbeats.heard("slow", millis(at));
      }
      changes.addAll(heartbeats.check(millis(at)));
    }

    assertThat(changes)
        .extracting(Heartbeats.Change::name, Heartbeats.Change::now)
        .startsWith(tuple("slow", Condition.SUSPECTED), tuple("slow", Condition.ALIVE));
  }

  @Test
  void thatAllFallSilentAtOnceGivesThemNoTime() {
    for (long at = 0; at <= 5_000; at += 500) {
      heartbeats.heard("a", millis(at));
      heartbeats.heard("b", millis(at));
      changes.addAll(heartbeats.check(millis(at)));
    }
    check(5_500, 9_000);

    assertThat(changes)
        .filteredOn(change -> change.now() == Condition.LOST)
        .extracting(Heartbeats.Change::silence)
        .containsExactly(millis(4_000), millis(4_000));
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
