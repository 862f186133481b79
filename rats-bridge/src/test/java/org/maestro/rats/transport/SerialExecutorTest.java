package org.maestro.rats.transport;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;

class SerialExecutorTest {

  private final SerialExecutor work = new SerialExecutor();

  @Test
  void keepsTheOrderAlsoOfWhatAnActionBrings() {
    List<String> done = new ArrayList<>();
    work.run(
        () -> {
          work.run(() -> done.add("second"));
          done.add("first");
          assertThat(work.isWithin()).isTrue();
        });
    work.run(() -> done.add("third"));
    assertThat(done).containsExactly("first", "second", "third");
    assertThat(work.isWithin()).isFalse();
  }

  @Test
  void neverTwoAreAtItAndNoneIsLost() throws InterruptedException {
    int[] unguarded = new int[1];
    AtomicInteger atOnce = new AtomicInteger();
    AtomicInteger most = new AtomicInteger();
    ExecutorService threads = Executors.newFixedThreadPool(4);
    for (int thread = 0; thread < 4; thread++) {
      threads.execute(
          () -> {
            for (int round = 0; round < 10_000; round++) {
              work.run(
                  () -> {
                    most.accumulateAndGet(atOnce.incrementAndGet(), Math::max);
                    unguarded[0]++;
                    atOnce.decrementAndGet();
                  });
            }
          });
    }
    threads.shutdown();
    assertThat(threads.awaitTermination(30, TimeUnit.SECONDS)).isTrue();
    work.run(() -> assertThat(unguarded[0]).isEqualTo(40_000));
    assertThat(most).hasValue(1);
  }

  @Test
  void goesOnAfterAnError() {
    List<String> done = new ArrayList<>();
    assertThatThrownBy(
            () ->
                work.run(
                    () -> {
                      work.run(() -> done.add("next"));
                      throw new AssertionError("meant to break");
                    }))
        .isInstanceOf(AssertionError.class);
    work.run(() -> done.add("later"));
    assertThat(done).containsExactly("next", "later");
  }
}
