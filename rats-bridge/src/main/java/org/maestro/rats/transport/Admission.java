package org.maestro.rats.transport;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;

/**
 * The order in which the clients of a process connect: few at a time. A broker that a thousand ask
 * at once, when a building starts or the broker itself is back, answers none of them before it
 * gives up and asks again. Any thread.
 */
public final class Admission {
  /** So many connect and subscribe at the same time. */
  private static final int MOST = 16;

  /** Who is let in next is not run within the one that made room. */
  private final SerialExecutor doorkeeper = new SerialExecutor();

  private final Deque<Runnable> waiting = new ArrayDeque<>();
  private int inside;

  /**
   * Runs the action when there is room; it blocks nowhere. Each that was run has to {@link #leave}
   * once.
   */
  void enter(Runnable admitted) {
    synchronized (this) {
      if (inside == MOST) {
        waiting.add(admitted);
        return;
      }
      inside++;
    }
    doorkeeper.run(admitted);
  }

  void leave() {
    Optional<Runnable> next;
    synchronized (this) {
      next = Optional.ofNullable(waiting.poll());
      if (next.isEmpty()) {
        inside--;
      }
    }
    next.ifPresent(doorkeeper::run);
  }
}
