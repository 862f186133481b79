package org.maestro.rats.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;

/** One at a time, in order, and guests do not do others' work. */
class TurnsTest {

  /** What the own thread is given, done when the test says so. */
  private final Queue<Runnable> own = new ArrayDeque<>();

  private final Turns turns = new Turns(own::add);
  private final List<String> done = new ArrayList<>();

  @Test
  void aGuestDoesItsActionAtOnceAndWhatItBrings() {
    turns.doOrAdd(
        () -> {
          turns.add(() -> done.add("brought"));
          turns.doOrAdd(() -> done.add("brought too"));
          done.add("first");
        });
    assertThat(done).containsExactly("first", "brought", "brought too");
    assertThat(own).isEmpty();
  }

  @Test
  void aGuestWaitsForItsTurnBehindWhatCameBefore() {
    turns.add(() -> done.add("before"));
    turns.doOrAdd(() -> done.add("guest"));
    assertThat(done).isEmpty();
    ownThreadWorks();
    assertThat(done).containsExactly("before", "guest");
  }

  @Test
  void aGuestThatBringsEverMoreIsRelieved() {
    turns.doOrAdd(this::again);
    int byGuest = done.size();
    assertThat(byGuest).isBetween(2, 100);
    own.remove().run();
    assertThat(done).as("one turn, then the thread's other work").hasSize(byGuest + 1);
    assertThat(own).hasSize(1);
  }

  private void again() {
    done.add("again");
    turns.add(this::again);
  }

  private void ownThreadWorks() {
    while (!own.isEmpty()) {
      own.remove().run();
    }
  }

  @Test
  void guestsOfManyThreadsTakeTurns() throws InterruptedException {
    ExecutorService ownThread = Executors.newSingleThreadExecutor();
    ExecutorService guests = Executors.newFixedThreadPool(4);
    Turns shared = new Turns(ownThread);
    AtomicInteger within = new AtomicInteger();
    List<Integer> most = Collections.synchronizedList(new ArrayList<>());
    int[] lastOf = new int[4];
    List<String> disorder = Collections.synchronizedList(new ArrayList<>());
    try {
      IntStream.range(0, 4)
          .forEach(
              guest ->
                  guests.execute(
                      () -> {
                        for (int number = 1; number <= 2_000; number++) {
                          int own = number;
                          shared.doOrAdd(
                              () -> {
                                most.add(within.incrementAndGet());
                                if (lastOf[guest] != own - 1) {
                                  disorder.add(guest + ": " + own);
                                }
                                lastOf[guest] = own;
                                within.decrementAndGet();
                              });
                        }
                      }));
      Awaitility.await().atMost(Duration.ofSeconds(60)).until(() -> most.size() == 8_000);
    } finally {
      guests.shutdownNow();
      ownThread.shutdown();
      assertThat(ownThread.awaitTermination(60, TimeUnit.SECONDS)).isTrue();
    }
    assertThat(most).hasSize(8_000).containsOnly(1);
    assertThat(disorder).isEmpty();
  }
}
