package org.maestro.rats.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

class SteppedClockTest {

  private final SteppedClock clock = new SteppedClock();
  private final List<String> log = new ArrayList<>();

  @Test
  void startsAtAFixedInstant() {
    assertThat(clock.now()).isZero();
    assertThat(clock.instant()).isEqualTo(Instant.parse("2026-01-01T00:00:00Z"));
  }

  @Test
  void runsEventsByTimeThenByTheOrderOfTheirScheduling() {
    schedule(2, "rose", "late");
    schedule(1, "zoe", "first of the simultaneous");
    schedule(1, "anna", "second of the simultaneous");
    clock.run(Duration.ofSeconds(10));
    assertThat(log)
        .containsExactly("1 first of the simultaneous", "1 second of the simultaneous", "2 late");
    assertThat(clock.now()).isEqualTo(Duration.ofSeconds(10));
  }

  @Test
  void shuffledByASeedKeepsTheOrderOfEachOwnerAlone() {
    Set<List<String>> orders = new HashSet<>();
    for (long seed = 0; seed < 50; seed++) {
      List<String> order = shuffled(seed);
      assertThat(order).filteredOn(text -> text.startsWith("anna")).isSorted();
      assertThat(order).filteredOn(text -> text.startsWith("zoe")).isSorted();
      assertThat(shuffled(seed)).isEqualTo(order);
      assertThat(order.get(6)).isEqualTo("late");
      orders.add(order);
    }
    assertThat(orders).hasSizeGreaterThan(1);
  }

  private static List<String> shuffled(long seed) {
    SteppedClock shuffled = SteppedClock.shuffled(seed);
    List<String> order = new ArrayList<>();
    shuffled.schedule(Duration.ofSeconds(2), "rose", () -> order.add("late"));
    for (int i = 0; i < 3; i++) {
      String number = String.valueOf(i);
      shuffled.schedule(Duration.ofSeconds(1), "zoe", () -> order.add("zoe " + number));
      shuffled.schedule(Duration.ofSeconds(1), "anna", () -> order.add("anna " + number));
    }
    shuffled.run(Duration.ofSeconds(3));
    return order;
  }

  @Test
  void stopsAsSoonAsTheConditionHolds() {
    schedule(1, "rose", "one");
    schedule(2, "rose", "two");
    assertThat(clock.runUntil(() -> log.size() == 1, Duration.ofSeconds(10))).isTrue();
    assertThat(clock.now()).isEqualTo(Duration.ofSeconds(1));
  }

  @Test
  void leavesEventsBeyondTheLimitForLater() {
    schedule(5, "rose", "five");
    assertThat(clock.runUntil(() -> !log.isEmpty(), Duration.ofSeconds(4))).isFalse();
    assertThat(clock.now()).isEqualTo(Duration.ofSeconds(4));
    assertThat(clock.runUntil(() -> !log.isEmpty(), Duration.ofSeconds(1))).isTrue();
  }

  @Test
  void doesNotRunWhatWasCancelled() {
    Clock.Timer timer = clock.schedule(Duration.ZERO, "rose", () -> log.add("never"));
    timer.cancel();
    timer.cancel();
    clock.run(Duration.ofSeconds(1));
    assertThat(log).isEmpty();
  }

  @Test
  void waitsForTicketsHeldByOtherThreads() {
    for (int round = 0; round < 50; round++) {
      int number = round;
      clock.schedule(
          Duration.ofMillis(round),
          "rose",
          () -> {
            Clock.Ticket ticket = clock.hold("rose");
            new Thread(
                    () -> {
                      log.add("work " + number + " at " + clock.now().toMillis());
                      clock.schedule(Duration.ZERO, "rose", () -> log.add("then " + number));
                      ticket.close();
                      ticket.close();
                    })
                .start();
          });
    }
    clock.run(Duration.ofSeconds(1));
    assertThat(log).hasSize(100);
    for (int round = 0; round < 50; round++) {
      assertThat(log.get(2 * round)).isEqualTo("work " + round + " at " + round);
      assertThat(log.get(2 * round + 1)).isEqualTo("then " + round);
    }
  }

  @Test
  void namesTheHoldersWhenItStalls() {
    SteppedClock impatient = new SteppedClock(Duration.ofMillis(20));
    impatient.hold("rose");
    assertThatThrownBy(() -> impatient.run(Duration.ofSeconds(1)))
        .isInstanceOf(ClockStalledException.class)
        .hasMessageContaining("rose");
  }

  @Test
  void isNotDrivenFromWithinAnAction() {
    clock.schedule(Duration.ZERO, "rose", () -> clock.run(Duration.ofSeconds(1)));
    assertThatThrownBy(() -> clock.run(Duration.ofSeconds(1)))
        .isInstanceOf(IllegalStateException.class);
    clock.run(Duration.ofSeconds(1));
  }

  @Property(tries = 50)
  void timeNeverGoesBack(@ForAll List<@IntRange(min = -5, max = 100) Integer> delays) {
    SteppedClock own = new SteppedClock();
    List<Duration> seen = new ArrayList<>();
    delays.forEach(
        delay -> own.schedule(Duration.ofMillis(delay), "rose", () -> seen.add(own.now())));
    own.run(Duration.ofSeconds(1));
    assertThat(seen).hasSameSizeAs(delays).isSorted();
  }

  private void schedule(int seconds, String owner, String text) {
    clock.schedule(
        Duration.ofSeconds(seconds), owner, () -> log.add(clock.now().toSeconds() + " " + text));
  }
}
