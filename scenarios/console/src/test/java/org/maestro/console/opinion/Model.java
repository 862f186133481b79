package org.maestro.console.opinion;

import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;

/** A server that answers as a language model does, or not at all. */
public final class Model implements AutoCloseable {
  private static final int OK = 200;

  private final HttpServer server;
  private final ExecutorService threads = Executors.newCachedThreadPool();
  private final CountDownLatch end = new CountDownLatch(1);
  private final List<String> asked = new CopyOnWriteArrayList<>();

  /** Takes the exchange, of which the body was read. */
  private interface Answer {
    void to(HttpExchange exchange) throws IOException, InterruptedException;
  }

  private Model(Answer answer) {
    try {
      server = HttpServer.create(new InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    server.setExecutor(threads);
    server.createContext(
        "/v1/chat/completions",
        exchange -> {
          asked.add(
              exchange.getRequestHeaders().getFirst("Authorization")
                  + "\n"
                  + new String(exchange.getRequestBody().readAllBytes(), StandardCharsets.UTF_8));
          try (exchange) {
            answer.to(exchange);
          } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
          }
        });
    server.start();
  }

  /** Says that. */
  public static Model saying(String text) {
    return sending(
        OK,
        "{\"choices\":[{\"message\":{\"role\":\"assistant\",\"content\":\"%s\"}}]}"
            .formatted(text.replace("\"", "\\\"").replace("\n", "\\n")));
  }

  static Model sending(int status, String body) {
    byte[] bytes = body.getBytes(StandardCharsets.UTF_8);
    return new Model(
        exchange -> {
          exchange.sendResponseHeaders(status, bytes.length);
          exchange.getResponseBody().write(bytes);
        });
  }

  /** Takes what it is asked, and never answers. */
  public static Model silent() {
    Model[] model = new Model[1];
    model[0] = new Model(exchange -> model[0].end.await());
    return model[0];
  }

  /** Begins to answer, and never goes on. */
  static Model stalling() {
    Model[] model = new Model[1];
    model[0] =
        new Model(
            exchange -> {
              exchange.sendResponseHeaders(OK, 0);
              exchange.getResponseBody().write('{');
              exchange.getResponseBody().flush();
              model[0].end.await();
            });
    return model[0];
  }

  /** Answers without an end. */
  static Model endless() {
    return new Model(
        exchange -> {
          exchange.sendResponseHeaders(OK, 0);
          byte[] spaces = " ".repeat(1 << 10).getBytes(StandardCharsets.UTF_8);
          while (!Thread.currentThread().isInterrupted()) {
            exchange.getResponseBody().write(spaces);
          }
        });
  }

  public URI base() {
    return URI.create("http://127.0.0.1:" + server.getAddress().getPort() + "/v1");
  }

  /** What it was asked, each with who asked before it. */
  public List<String> asked() {
    return List.copyOf(asked);
  }

  @Override
  public void close() {
    end.countDown();
    server.stop(0);
    threads.shutdownNow();
  }
}
