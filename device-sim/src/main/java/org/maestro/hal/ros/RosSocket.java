package org.maestro.hal.ros;

import java.io.IOException;
import java.net.ConnectException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpTimeoutException;
import java.net.http.WebSocket;
import java.net.http.WebSocketHandshakeException;
import java.nio.ByteBuffer;
import java.nio.channels.UnresolvedAddressException;
import java.time.Duration;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** One WebSocket to a server, for as long as it stands. One thread sends, and waits until it is. */
final class RosSocket implements WebSocket.Listener {

  private static final Duration CONNECTS_WITHIN = Duration.ofSeconds(5);
  private static final Duration SENDS_WITHIN = Duration.ofSeconds(5);

  /** More than an image of a usual camera has in base64. */
  private static final int MOST_CHARACTERS = 32 << 20;

  private final Consumer<String> heard;
  private final StringBuilder text = new StringBuilder();
  private final CompletableFuture<String> end = new CompletableFuture<>();
  private final CompletableFuture<WebSocket> socket = new CompletableFuture<>();
  private volatile boolean cut;
  private volatile long aliveAtNanos = System.nanoTime();

  private RosSocket(Consumer<String> heard) {
    this.heard = heard;
  }

  /**
   * Waits until it stands.
   *
   * @param heard told each whole message, on a thread of the client's
   * @throws IOException with why it does not stand, for people
   */
  static RosSocket connect(HttpClient client, URI server, Consumer<String> heard)
      throws IOException, InterruptedException {
    RosSocket listening = new RosSocket(heard);
    CompletableFuture<WebSocket> opening =
        client.newWebSocketBuilder().connectTimeout(CONNECTS_WITHIN).buildAsync(server, listening);
    try {
      opening.get(2 * CONNECTS_WITHIN.toMillis(), TimeUnit.MILLISECONDS);
      return listening;
    } catch (TimeoutException e) {
      listening.cut();
      throw new IOException("it does not open a WebSocket", e);
    } catch (ExecutionException e) {
      throw new IOException(why(e.getCause()), e);
    }
  }

  private static String why(@Nullable Throwable cause) {
    if (cause instanceof WebSocketHandshakeException refused) {
      return "what answers opens no WebSocket (HTTP status %d)"
          .formatted(refused.getResponse().statusCode());
    }
    if (cause instanceof HttpTimeoutException) {
      return "it does not open a WebSocket";
    }
    if (cause instanceof ConnectException none) {
      return none.getCause() instanceof UnresolvedAddressException
          ? "there is no such host"
          : "nobody listens there";
    }
    return cause == null ? "" : Objects.requireNonNullElse(cause.getMessage(), cause.toString());
  }

  /**
   * @throws IOException when it could not be sent in time, for people
   */
  void send(String message) throws IOException, InterruptedException {
    await(socket.thenCompose(open -> open.sendText(message, true)));
  }

  /** Asks for a sign of life. */
  void ping() throws IOException, InterruptedException {
    await(socket.thenCompose(open -> open.sendPing(ByteBuffer.allocate(0))));
  }

  /** Says goodbye. */
  void leave() throws IOException, InterruptedException {
    await(socket.thenCompose(open -> open.sendClose(WebSocket.NORMAL_CLOSURE, "")));
  }

  private static void await(CompletableFuture<WebSocket> sent)
      throws IOException, InterruptedException {
    try {
      sent.get(SENDS_WITHIN.toMillis(), TimeUnit.MILLISECONDS);
    } catch (TimeoutException e) {
      throw new IOException("it takes no messages any more", e);
    } catch (ExecutionException e) {
      throw new IOException("the connection broke", e);
    }
  }

  /** Why it stands no more; empty: it does. */
  Optional<String> ended() {
    return Optional.ofNullable(end.getNow(null));
  }

  /** Since when nothing has come, not even an answer to a ping. */
  Duration silentFor() {
    return Duration.ofNanos(System.nanoTime() - aliveAtNanos);
  }

  /** Without goodbye. */
  void cut() {
    cut = true;
    Optional.ofNullable(socket.getNow(null)).ifPresent(WebSocket::abort);
  }

  @Override
  public void onOpen(WebSocket opened) {
    socket.complete(opened);
    if (cut) {
      opened.abort();
    }
    opened.request(1);
  }

  @Override
  public @Nullable CompletionStage<?> onText(WebSocket from, CharSequence data, boolean last) {
    aliveAtNanos = System.nanoTime();
    text.append(data);
    if (text.length() > MOST_CHARACTERS) {
      end.complete("it sent a message of more than %d characters".formatted(MOST_CHARACTERS));
      from.abort();
      return null;
    }
    if (last) {
      String whole = text.toString();
      text.setLength(0);
      heard.accept(whole);
    }
    from.request(1);
    return null;
  }

  @Override
  public @Nullable CompletionStage<?> onPong(WebSocket from, ByteBuffer message) {
    aliveAtNanos = System.nanoTime();
    from.request(1);
    return null;
  }

  @Override
  public @Nullable CompletionStage<?> onClose(WebSocket from, int status, String reason) {
    end.complete("it has closed the connection");
    return null;
  }

  @Override
  public void onError(WebSocket from, Throwable error) {
    end.complete("the connection broke");
  }
}
