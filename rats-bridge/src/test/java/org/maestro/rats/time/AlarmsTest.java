package org.maestro.rats.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** In the order of their times, and no thread is woken without need. */
class AlarmsTest {

  private final ScheduledThreadPoolExecutor thread = new ScheduledThreadPoolExecutor(1);
  private final List<String> rung = new CopyOnWriteArrayList<>();
  private final AtomicLong nanos = new AtomicLong();
  private final Alarms alarms = new Alarms(thread, Runnable::run, nanos::get);

  @AfterEach
  void stop() {
    thread.shutdownNow();
  }

  @Test
  void ringInTheOrderOfTheirTimesAndThenOfTheirSetting() {
    add(60, "third");
    add(20, "first");
    add(60, "fourth");
    add(40, "second");
    nanos.set(TimeUnit.SECONDS.toNanos(1));
    Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> rung.size() == 4);
    assertThat(rung).containsExactly("first", "second", "third", "fourth");
  }

  @Test
  void whatIsCancelledDoesNotRing() {
    Clock.Timer cancelled = add(20, "cancelled");
    add(40, "other");
    cancelled.cancel();
    cancelled.cancel();
    nanos.set(TimeUnit.SECONDS.toNanos(1));
    Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> !rung.isEmpty());
    assertThat(rung).containsExactly("other");
  }

  @Test
  void limitsThatAreCancelledInTimeWakeTheThreadOnceOnly() {
    alarms.add(TimeUnit.MINUTES.toNanos(10), () -> {}).cancel();
    Object set = thread.getQueue().peek();
    for (int call = 0; call < 100; call++) {
      alarms.add(TimeUnit.MINUTES.toNanos(11), () -> {}).cancel();
    }
    assertThat(thread.getQueue()).hasSize(1);
    assertThat(thread.getQueue().peek()).isSameAs(set);
    add(1, "before all");
    nanos.set(TimeUnit.SECONDS.toNanos(1));
    Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> rung.size() == 1);
  }

  @Test
  void theLongestTimeIsNoMistake() {
    alarms.add(Long.MAX_VALUE, () -> rung.add("never"));
    add(1, "soon");
    nanos.set(TimeUnit.SECONDS.toNanos(1));
    Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> rung.size() == 1);
    assertThat(rung).containsExactly("soon");
  }

  private Clock.Timer add(int millis, String name) {
    return alarms.add(TimeUnit.MILLISECONDS.toNanos(millis), () -> rung.add(name));
  }
}
