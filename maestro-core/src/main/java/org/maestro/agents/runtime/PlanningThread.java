package org.maestro.agents.runtime;

import java.time.Duration;
import java.util.concurrent.PriorityBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;

/**
 * Does one thing after the other on a thread of its own, what is due first before the rest: what
 * can wait is overtaken by what cannot, and by nothing once its time has come. Any thread may hand
 * work over.
 */
public final class PlanningThread {

  private record Turn(long dueNanos, long sequence, Runnable work)
      implements Runnable, Comparable<Turn> {
    @Override
    public void run() {
      work.run();
    }

    @Override
    public int compareTo(Turn other) {
      int byTime = Long.signum(dueNanos - other.dueNanos);
      return byTime != 0 ? byTime : Long.compare(sequence, other.sequence);
    }
  }

  private final AtomicLong sequence = new AtomicLong();
  private final ThreadPoolExecutor thread =
      new ThreadPoolExecutor(
          1, 1, 0, TimeUnit.SECONDS, new PriorityBlockingQueue<>(), PlanningThread::thread);

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "planning");
    thread.setDaemon(true);
    return thread;
  }

  /**
   * Has it done.
   *
   * @param patience for so long it may be overtaken; real time
   */
  public void execute(Runnable work, Duration patience) {
    long due = System.nanoTime() + patience.toNanos();
    thread.execute(new Turn(due, sequence.getAndIncrement(), work));
  }

  /** What has not begun is not done any more, and what has begun is interrupted. */
  public void end() {
    thread.shutdownNow();
  }
}
