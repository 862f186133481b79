package org.maestro.agents.runtime;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.Agent;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

/** What wakes an agent while it begins to rest. */
class ReceptionTest {
  private static final int TIMES = 500_000;
  private static final int OVER = -1;
  private static final Duration LONGEST = Duration.ofSeconds(2);

  /** JADE keeps a behaviour awake that was restarted since it began to act, or is runnable. */
  @Test
  void isNotLost() throws Exception {
    Reception reception = new Reception(new Agent(), List.of(), () -> false, () -> {});
    AtomicInteger resting = new AtomicInteger();
    AtomicInteger woken = new AtomicInteger();
    Thread waking =
        new Thread(
            () -> {
              for (int time = 1; await(resting, time); time++) {
                reception.handleRestartEvent();
                woken.set(time);
              }
            });
    waking.start();
    int lost = 0;
    long end = System.nanoTime() + LONGEST.toNanos();
    for (int time = 1; time <= TIMES && System.nanoTime() < end; time++) {
      long before = reception.getRestartCounter();
      resting.set(time);
      reception.block();
      await(woken, time);
      if (!reception.isRunnable() && reception.getRestartCounter() == before) {
        lost++;
      }
    }
    resting.set(OVER);
    waking.join();
    assertThat(lost).isZero();
  }

  /** Whether it has got there; not, when it is over. */
  private static boolean await(AtomicInteger counter, int value) {
    int now = counter.get();
    for (; now != OVER && now < value; now = counter.get()) {
      Thread.yield();
    }
    return now != OVER;
  }
}
