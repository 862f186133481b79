package org.maestro.junit;

import java.net.URI;
import org.maestro.rats.broker.EmbeddedBroker;

/** The one broker of this JVM's tests, started when the first paced class needs it. */
final class SharedBroker implements AutoCloseable {

  private final EmbeddedBroker broker = EmbeddedBroker.start();

  URI uri() {
    return broker.uri();
  }

  @Override
  public void close() {
    broker.close();
  }
}
