package org.maestro.console;

import java.util.concurrent.ArrayBlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import org.maestro.console.questions.RefusalException;

/**
 * Work for the API that takes long, one after the other on a thread of its own; what would have to
 * wait behind too much of it is refused. Any thread may bring some.
 */
final class OneByOne implements AutoCloseable {
  private static final int MOST_WAITING = 4;

  private final ThreadPoolExecutor thread;
  private final String busy;

  /**
   * @param name of the thread
   * @param busy the sentence that refuses
   */
  OneByOne(String name, String busy) {
    this.busy = busy;
    this.thread =
        new ThreadPoolExecutor(
            1,
            1,
            0,
            TimeUnit.SECONDS,
            new ArrayBlockingQueue<>(MOST_WAITING),
            task -> {
              Thread named = new Thread(task, name);
              named.setDaemon(true);
              return named;
            });
  }

  <T> CompletableFuture<T> work(Supplier<T> work) {
    try {
      return CompletableFuture.supplyAsync(work, thread);
    } catch (RejectedExecutionException e) {
      return CompletableFuture.failedFuture(RefusalException.outside(busy));
    }
  }

  @Override
  public void close() {
    thread.shutdownNow();
  }
}
