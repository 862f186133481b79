package org.maestro.rats.transport;

import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;

/**
 * Has actions done one at a time, in the order in which they came, by whichever thread brings one
 * while none is at it: it does its own, and those that come meanwhile. No lock is held while an
 * action runs, and no thread is woken for it, which takes longer than most of them do. Any thread.
 */
final class SerialExecutor {

  private final Queue<Runnable> waiting = new ConcurrentLinkedQueue<>();
  private final AtomicInteger open = new AtomicInteger();
  private volatile @Nullable Thread atWork;

  /**
   * @param action that blocks nowhere, and throws nothing but what ends the thread
   */
  void run(Runnable action) {
    waiting.add(action);
    if (open.getAndIncrement() > 0) {
      return;
    }
    Optional<Error> fatal = Optional.empty();
    do {
      atWork = Thread.currentThread();
      try {
        waiting.remove().run();
      } catch (Error error) {
        // Others rely on theirs being done.
        fatal = Optional.of(error);
      }
      atWork = null;
    } while (open.decrementAndGet() > 0);
    if (fatal.isPresent()) {
      throw fatal.get();
    }
  }

  /** Whether this is asked from within an action. */
  boolean isWithin() {
    return atWork == Thread.currentThread();
  }
}
