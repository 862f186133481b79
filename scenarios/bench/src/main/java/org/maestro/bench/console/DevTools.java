package org.maestro.bench.console;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.WebSocket;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.atomic.AtomicInteger;
import org.maestro.assembly.SiteException;

/** The protocol by which a browser lets itself be driven, for one of its pages. For one thread. */
final class DevTools implements AutoCloseable {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final long PATIENCE_SECONDS = 120;

  private final Map<Integer, CompletableFuture<JsonNode>> asked = new ConcurrentHashMap<>();
  private final AtomicInteger number = new AtomicInteger();
  private final WebSocket socket;

  private DevTools(URI page) {
    this.socket =
        HttpClient.newHttpClient()
            .newWebSocketBuilder()
            .buildAsync(page, new Answers())
            .orTimeout(PATIENCE_SECONDS, TimeUnit.SECONDS)
            .join();
  }

  static DevTools of(URI page) {
    return new DevTools(page);
  }

  /** What the browser answers to a command. */
  JsonNode send(String method, ObjectNode parameters) {
    int id = number.incrementAndGet();
    CompletableFuture<JsonNode> answer = new CompletableFuture<>();
    asked.put(id, answer);
    ObjectNode command = MAPPER.createObjectNode().put("id", id).put("method", method);
    command.set("params", parameters);
    try {
      socket.sendText(command.toString(), true).get(PATIENCE_SECONDS, TimeUnit.SECONDS);
      JsonNode whole = answer.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
      if (whole.has("error")) {
        throw new SiteException(
            "The browser does not do %s: %s".formatted(method, whole.path("error")));
      }
      return whole.path("result");
    } catch (TimeoutException | ExecutionException e) {
      throw new SiteException("The browser does not answer to " + method + ".", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SiteException("Interrupted while the browser was asked.", e);
    } finally {
      asked.remove(id);
    }
  }

  JsonNode send(String method) {
    return send(method, MAPPER.createObjectNode());
  }

  /** The value of an expression in the page; a promise is waited for. */
  JsonNode value(String script) {
    JsonNode answer =
        send(
            "Runtime.evaluate",
            MAPPER
                .createObjectNode()
                .put("expression", script)
                .put("awaitPromise", true)
                .put("returnByValue", true));
    if (answer.has("exceptionDetails")) {
      throw new SiteException(
          "The page fails at a script: "
              + answer.path("exceptionDetails").path("exception").path("description").asText());
    }
    return answer.path("result").path("value");
  }

  /** Has the script run in each page that comes, before anything of its own. */
  void beforeEachPage(String script) {
    send("Page.addScriptToEvaluateOnNewDocument", MAPPER.createObjectNode().put("source", script));
  }

  void go(URI address) {
    send("Page.navigate", MAPPER.createObjectNode().put("url", address.toString()));
  }

  void size(int width, int height) {
    send(
        "Emulation.setDeviceMetricsOverride",
        MAPPER
            .createObjectNode()
            .put("width", width)
            .put("height", height)
            .put("deviceScaleFactor", 1)
            .put("mobile", false));
  }

  @Override
  public void close() {
    socket.abort();
  }

  /** Pieces of answers, until each is whole. */
  private final class Answers implements WebSocket.Listener {
    private final StringBuilder pieces = new StringBuilder();

    @Override
    public CompletionStage<?> onText(WebSocket from, CharSequence text, boolean last) {
      pieces.append(text);
      if (last) {
        take(pieces.toString());
        pieces.setLength(0);
      }
      from.request(1);
      return CompletableFuture.completedStage(null);
    }

    private void take(String text) {
      try {
        JsonNode answer = MAPPER.readTree(text);
        CompletableFuture<JsonNode> waiting = asked.get(answer.path("id").asInt());
        if (waiting != null) {
          waiting.complete(answer);
        }
      } catch (JsonProcessingException e) {
        throw new SiteException("The browser answers with what is no JSON.", e);
      }
    }
  }
}
