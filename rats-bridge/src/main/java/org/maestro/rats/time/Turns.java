package org.maestro.rats.time;

import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicInteger;
import org.jspecify.annotations.Nullable;

/**
 * Has actions done one at a time, in the order in which they came: by a thread of its own, or by
 * the one that brings an action while nothing else is to be done. Such a guest does its own action
 * and what that action itself brought, no more than some, so that nobody's work holds it up. To
 * wake a thread takes longer than most actions do. Any thread.
 */
final class Turns {

  private static final int MOST_BY_GUEST = 16;

  private final Executor own;
  private final Queue<Runnable> waiting = new ConcurrentLinkedQueue<>();
  private final AtomicInteger open = new AtomicInteger();
  private volatile @Nullable Thread atWork;

  /** By actions of the thread at work; only that thread touches it. */
  private int broughtMeanwhile;

  /**
   * @param own the thread that does what nobody else does; what is given to it may wait behind
   *     other work of its
   */
  Turns(Executor own) {
    this.own = own;
  }

  /** To be done on the own thread, or by a guest whose action brings it. */
  void add(Runnable action) {
    if (isFirst(action)) {
      own.execute(this::work);
    }
  }

  /** To be done at once if nothing else is to be done, else in its turn. */
  void doOrAdd(Runnable action) {
    if (isFirst(action)) {
      int left = 1;
      int done = 0;
      boolean more = true;
      while (more && left > 0 && done < MOST_BY_GUEST) {
        broughtMeanwhile = 0;
        more = doNext();
        left += broughtMeanwhile - 1;
        done++;
      }
      if (more) {
        own.execute(this::work);
      }
    }
  }

  /** As many as there are now: what comes meanwhile waits behind what the own thread has to do. */
  private void work() {
    int left = open.get();
    boolean more = true;
    while (more && left > 0) {
      more = doNext();
      left--;
    }
    if (more) {
      own.execute(this::work);
    }
  }

  private boolean isFirst(Runnable action) {
    waiting.add(action);
    if (atWork == Thread.currentThread()) {
      broughtMeanwhile++;
    }
    return open.getAndIncrement() == 0;
  }

  /** Returns whether there are more. */
  private boolean doNext() {
    atWork = Thread.currentThread();
    try {
      waiting.remove().run();
    } finally {
      atWork = null;
    }
    return open.decrementAndGet() > 0;
  }
}
