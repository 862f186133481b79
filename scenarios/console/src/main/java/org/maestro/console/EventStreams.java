package org.maestro.console;

import io.javalin.http.sse.SseClient;
import java.time.Duration;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The streams of server-sent events, each with a thread of its own: a listener that does not read
 * keeps nobody else from hearing.
 */
final class EventStreams implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(EventStreams.class);
  private static final int END_SECONDS = 2;
  private static final Duration BREATH = Duration.ofSeconds(10);

  private final ExecutorService threads =
      Executors.newCachedThreadPool(
          task -> {
            Thread thread = new Thread(task, "console-stream");
            thread.setDaemon(true);
            return thread;
          });

  /**
   * Tells the client what happens there, until either side ends it.
   *
   * @param lasts whether she may hear it still
   */
  void serve(SseClient client, EventSource events, BooleanSupplier lasts) {
    EventQueue queue = new EventQueue();
    client.keepAlive();
    client.onClose(
        () -> {
          queue.end();
          events.leave(queue);
        });
    events.listen(queue, () -> threads.execute(() -> send(client, queue, lasts)));
  }

  private static void send(SseClient client, EventQueue queue, BooleanSupplier lasts) {
    try {
      if (queue.isOver()) {
        client.sendEvent("full", "Too many listen already; close another page.");
      }
      while (!queue.isOver() && !client.terminated() && lasts.getAsBoolean()) {
        queue
            .next(BREATH)
            .ifPresentOrElse(
                event -> client.sendEvent(event.name(), event.document()),
                // Only who is written to is found to be gone.
                () -> client.sendComment("nothing new"));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (IllegalStateException e) {
      LOG.debug("A listener has gone while it was written to", e);
    } finally {
      if (!client.terminated()) {
        client.close();
      }
    }
  }

  /** Each stream is ended by its own thread, as long as the server still stands. */
  @Override
  public void close() {
    threads.shutdownNow();
    try {
      if (!threads.awaitTermination(END_SECONDS, TimeUnit.SECONDS)) {
        LOG.debug("A listener does not read; its stream ends with the server");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
