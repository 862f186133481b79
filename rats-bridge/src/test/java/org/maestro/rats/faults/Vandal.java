package org.maestro.rats.faults;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** A client that says to the bus what nobody should, and the answers that it gets. */
final class Vandal {

  final List<Result> results = new CopyOnWriteArrayList<>();
  private final SteppedClock clock;
  private final Transport transport;

  private Vandal(SteppedClock clock, Transport transport) {
    this.clock = clock;
    this.transport = transport;
  }

  /** Comes to the bus, and waits until it and all who came before are there. */
  static Vandal join(InProcessBus bus, Topics topics, SteppedClock clock) {
    Vandal vandal = new Vandal(clock, bus.client("vandal"));
    WireFormat wire = new WireFormat();
    vandal.hear(
        topics.results("vandal"),
        message -> vandal.results.add(wire.decodeResult(message.payload())));
    vandal.transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            // It is, some messages later.
          }

          @Override
          public void lost(String reason) {
            throw new AssertionError(reason);
          }
        });
    clock.run(Duration.ofSeconds(1));
    return vandal;
  }

  void hear(String filter, Transport.MessageHandler handler) {
    transport.subscribe(filter, Transport.RetainedMessages.IGNORE, handler);
  }

  void publish(Publication publication) {
    transport.publish(publication, failure -> assertThat(failure).isEmpty());
  }

  /** Publishes it, and waits until it was answered. */
  void say(String topic, byte[] payload) {
    publish(Publication.reliable(topic, payload, Optional.empty()));
    clock.run(Duration.ofMillis(100));
  }
}
