package org.maestro.rats.broker;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.IntFunction;

/** A broker that a test starts, stops, and starts again empty on the same port. */
public final class TestBroker {

  /** A running broker. */
  interface Running extends AutoCloseable {
    URI uri();

    /** Has it read its files again, if it has to be told. */
    default void told() {
      // It looks by itself.
    }

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
    return new TestBroker(port -> running(EmbeddedBroker.start(port)));
  }

  /** Artemis, in this process, with the files of a secured site. */
  public static TestBroker embeddedSecured(Path files) {
    return new TestBroker(
        port -> running(EmbeddedBroker.startSecured(files.resolve("artemis"), port)));
  }

  private static Running running(EmbeddedBroker broker) {
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
  }

  /** The program mosquitto. */
  public static TestBroker mosquitto() {
    return new TestBroker(Mosquitto::start);
  }

  /**
   * The program mosquitto with the files of a secured site.
   *
   * @param mainPort which of their ports clients come to
   */
  public static TestBroker mosquittoSecured(Path files, int mainPort) {
    return new TestBroker(port -> Mosquitto.startSecured(files, mainPort, port));
  }

  public void start() {
    assertThat(running).as("the broker that runs already").isEmpty();
    Running started = kind.apply(port);
    port = started.uri().getPort();
    running = Optional.of(started);
  }

  /** Tells it that its files have changed, in the way in which it has to be told. */
  public void tellOfChanges() {
    running.ifPresent(Running::told);
  }

  /** At once, without farewell to its clients. */
  public void stop() {
    running.ifPresent(Running::close);
    running = Optional.empty();
  }

  public URI uri() {
    return running.map(Running::uri).orElseGet(() -> URI.create("tcp://127.0.0.1:" + port));
  }
}
