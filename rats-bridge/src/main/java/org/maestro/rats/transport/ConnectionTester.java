package org.maestro.rats.transport;

import java.net.URI;
import java.time.Duration;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;

/**
 * A test whether a broker lets a client in, made once before anything begins: a transport tries for
 * ever, as it should in a site that runs, and would do so with the wrong certificate, too. Any
 * thread may ask, and waits.
 */
public final class ConnectionTester {
  private static final Duration KEEP_ALIVE = Duration.ofSeconds(15);
  private static final Duration GOODBYE_WITHIN = Duration.ofSeconds(1);

  private final URI broker;
  private final Duration patience;

  /**
   * @param patience how long an answer may take
   */
  public ConnectionTester(URI broker, Duration patience) {
    this.broker = broker;
    this.patience = patience;
  }

  /** Why it does not let in who has no credentials; empty when it does. */
  public Optional<String> objection() {
    return objection("door-" + UUID.randomUUID(), Optional.empty());
  }

  /** Why it does not let this user in; empty when it does. */
  public Optional<String> objection(Credentials credentials) {
    return objection(credentials.user(), Optional.of(credentials));
  }

  private Optional<String> objection(String clientId, Optional<Credentials> credentials) {
    CompletableFuture<Optional<String>> answer = new CompletableFuture<>();
    PahoConnection connection =
        new PahoConnection(
            broker, clientId, KEEP_ALIVE, Optional.empty(), credentials, new Answer(answer));
    try {
      connection.connect();
      Optional<String> objection = answer.get(patience.toMillis(), TimeUnit.MILLISECONDS);
      if (objection.isEmpty()) {
        sayGoodbye(connection);
      }
      return objection;
    } catch (TimeoutException e) {
      return Optional.of("it has not answered within " + patience.toSeconds() + " s");
    } catch (ExecutionException e) {
      throw new IllegalStateException("An answer is never a failure", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.of("nobody waited for its answer");
    } finally {
      connection.cut();
    }
  }

  private static void sayGoodbye(PahoConnection connection) throws InterruptedException {
    CompletableFuture<Void> said = new CompletableFuture<>();
    connection.disconnect(() -> said.complete(null));
    try {
      said.get(GOODBYE_WITHIN.toMillis(), TimeUnit.MILLISECONDS);
    } catch (ExecutionException | TimeoutException e) {
      // The connection is cut then, which comes to the same.
    }
  }

  /** Told on Paho's threads. */
  private record Answer(CompletableFuture<Optional<String>> answer)
      implements PahoConnection.Events {
    @Override
    public void established(PahoConnection source, int receiveMaximum) {
      answer.complete(Optional.empty());
    }

    @Override
    public void ended(PahoConnection source, String reason) {
      answer.complete(Optional.of(reason));
    }

    @Override
    public void arrived(PahoConnection source, Message message) {
      // It subscribes to nothing.
    }
  }
}
