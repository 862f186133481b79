package org.maestro.rats.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.util.Optional;
import java.util.function.IntFunction;

/** A broker that a test starts, stops, and starts again empty on the same port. */
public final class TestBroker {

  /** A running broker. */
  interface Running extends AutoCloseable {
    URI uri();

    @Override
    void close();
  }

  private final IntFunction<Running> kind;
  private Optional<Running> running = Optional.empty();
  private int port;

  private TestBroker(IntFunction<Running> kind) {
    this.kind = kind;
  }

  /** Artemis, in this process. */
  public static TestBroker embedded() {
    return new TestBroker(
        port -> {
          EmbeddedBroker broker = EmbeddedBroker.start(port);
          return new Running() {
            @Override
            public URI uri() {
              return broker.uri();
            }

            @Override
            public void close() {
              broker.close();
            }
          };
        });
  }

  /** The program mosquitto. */
  public static TestBroker mosquitto() {
    return new TestBroker(Mosquitto::start);
  }

  public void start() {
    assertThat(running).as("the broker that runs already").isEmpty();
    Running started = kind.apply(port);
    port = started.uri().getPort();
    running = Optional.of(started);
  }

  /** At once, without farewell to its clients. */
  public void stop() {
    running.ifPresent(Running::close);
    running = Optional.empty();
  }

  public URI uri() {
    return URI.create("tcp://127.0.0.1:" + port);
  }
}
