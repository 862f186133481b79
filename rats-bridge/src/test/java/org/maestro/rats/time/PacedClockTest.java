package org.maestro.rats.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;

class PacedClockTest {

  @Test
  void runsFasterThanTheWall() throws InterruptedException {
    try (PacedClock clock = new PacedClock(1000)) {
      long before = System.nanoTime();
      CountDownLatch done = new CountDownLatch(1);
      clock.schedule(Duration.ofSeconds(20), "rose", done::countDown);
      assertThat(done.await(10, TimeUnit.SECONDS)).isTrue();
      assertThat(clock.now()).isGreaterThanOrEqualTo(Duration.ofSeconds(20));
      assertThat(System.nanoTime() - before).isGreaterThanOrEqualTo(20_000_000L);
    }
  }

  @Test
  void keepsTheOrderAndSurvivesFailures() throws InterruptedException {
    try (PacedClock clock = new PacedClock(1)) {
      List<Integer> order = new CopyOnWriteArrayList<>();
      CountDownLatch done = new CountDownLatch(1);
      for (int number = 0; number < 100; number++) {
        int own = number;
        clock.schedule(Duration.ZERO, "rose", () -> order.add(own));
      }
      clock.schedule(
          Duration.ZERO,
          "rose",
          () -> {
            throw new IllegalStateException("meant to fail");
          });
      clock.schedule(Duration.ZERO, "rose", done::countDown);
      assertThat(done.await(10, TimeUnit.SECONDS)).isTrue();
      assertThat(order).hasSize(100).isSorted();
    }
  }

  @Test
  void doesWhatComesFromOutsideAtOnceWhenItIsIdle() {
    try (PacedClock clock = new PacedClock(1)) {
      List<Thread> by = new CopyOnWriteArrayList<>();
      clock.perform("rose", () -> by.add(Thread.currentThread()));
      assertThat(by).containsExactly(Thread.currentThread());
    }
  }

  @Test
  void isNotKeptFromItsTimersByAFlood() throws InterruptedException {
    try (PacedClock clock = new PacedClock(1)) {
      CountDownLatch rung = new CountDownLatch(1);
      clock.schedule(Duration.ofMillis(20), "rose", rung::countDown);
      clock.schedule(Duration.ZERO, "flood", () -> flood(clock));
      assertThat(rung.await(60, TimeUnit.SECONDS)).isTrue();
    }
  }

  private static void flood(PacedClock clock) {
    clock.schedule(Duration.ZERO, "flood", () -> flood(clock));
  }

  @Test
  void doesNothingOnceClosed() {
    PacedClock clock = new PacedClock(1);
    clock.close();
    clock.schedule(Duration.ZERO, "rose", () -> {}).cancel();
    clock.hold("rose").close();
  }

  @Test
  void refusesASpeedThatIsNone() {
    assertThatThrownBy(() -> new PacedClock(0))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("speed");
  }
}
