package org.maestro.agents.runtime;

import java.time.Duration;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * Does one thing after the other on a thread of its own, for all who ask in turn: see {@link
 * PlanningTurns}. Any thread may hand work over.
 */
public final class PlanningThread {
  private final PlanningTurns turns = new PlanningTurns();
  private final ThreadPoolExecutor thread =
      new ThreadPoolExecutor(
          1, 1, 0, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), PlanningThread::thread);

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "planning");
    thread.setDaemon(true);
    return thread;
  }

  /**
   * Has it done.
   *
   * @param requester for whom
   * @param patience for so long it may be overtaken by what cannot wait; real time
   */
  public void execute(Runnable work, String requester, Duration patience) {
    turns.add(work, requester, System.nanoTime() + patience.toNanos());
    thread.execute(() -> turns.next(System.nanoTime()).run());
  }

  /** What has not begun is not done any more, and what has begun is interrupted. */
  public void end() {
    thread.shutdownNow();
  }
}
