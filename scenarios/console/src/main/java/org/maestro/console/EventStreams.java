package org.maestro.console;

import io.javalin.http.sse.SseClient;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/**
 * The streams of server-sent events, each with a thread of its own: a listener that does not read
 * keeps nobody else from hearing.
 */
final class EventStreams implements AutoCloseable {
  private final EventHub events;
  private final Set<SseClient> open = ConcurrentHashMap.newKeySet();
  private final ExecutorService threads =
      Executors.newCachedThreadPool(
          task -> {
            Thread thread = new Thread(task, "console-stream");
            thread.setDaemon(true);
            return thread;
          });

  EventStreams(EventHub events) {
    this.events = events;
  }

  /** Tells the client what happens, until either side ends it. */
  void serve(SseClient client) {
    EventQueue queue = new EventQueue();
    client.keepAlive();
    open.add(client);
    client.onClose(
        () -> {
          queue.end();
          open.remove(client);
          events.leave(queue);
        });
    events.listen(queue, () -> threads.execute(() -> send(client, queue)));
  }

  private static void send(SseClient client, EventQueue queue) {
    try {
      if (queue.isOver()) {
        client.sendEvent("full", "Too many listen already; close another page.");
      }
      while (!queue.isOver() && !client.terminated()) {
        queue
            .next()
            .ifPresentOrElse(
                event -> client.sendEvent(event.name(), event.document()),
                // Only who is written to is found to be gone.
                () -> client.sendComment("nothing new"));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      client.close();
    }
  }

  @Override
  public void close() {
    threads.shutdownNow();
    open.forEach(SseClient::close);
  }
}
