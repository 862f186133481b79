package org.maestro.console;

import io.javalin.http.sse.SseClient;
import java.time.Duration;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.maestro.console.access.Visit;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The streams of server-sent events, each with a thread of its own: a listener that does not read
 * keeps nobody else from hearing.
 */
final class EventStreams implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(EventStreams.class);
  private static final int END_SECONDS = 2;

  /** So that one leaves room for others. */
  private static final int MOST_OF_A_PERSON = 24;

  private static final Duration BREATH = Duration.ofSeconds(10);

  private final Map<String, Integer> listening = new ConcurrentHashMap<>();
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
   * @param visit hers, which has to last
   */
  void serve(SseClient client, EventSource events, Visit visit) {
    EventQueue queue = new EventQueue();
    client.keepAlive();
    if (!enter(visit)) {
      client.sendEvent("full", "You listen in too many pages already; close another one.");
      client.close();
      return;
    }
    client.onClose(
        () -> {
          queue.end();
          events.leave(queue);
          leave(visit);
        });
    events.listen(queue, () -> threads.execute(() -> send(client, queue, visit.lasts())));
  }

  private boolean enter(Visit visit) {
    return visit.person().isEmpty()
        || listening.merge(visit.person().get(), 1, Integer::sum) <= MOST_OF_A_PERSON
        || leave(visit);
  }

  /** Returns that she is not there any more. */
  private boolean leave(Visit visit) {
    visit
        .person()
        .ifPresent(
            person -> listening.computeIfPresent(person, (name, n) -> n == 1 ? null : n - 1));
    return false;
  }

  private static void send(SseClient client, EventQueue queue, BooleanSupplier lasts) {
    try {
      if (queue.isOver()) {
        client.sendEvent("full", "Too many listen already; close another page.");
      }
      // A browser takes nothing for a stream before it has heard something of it.
      client.sendComment("here");
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
