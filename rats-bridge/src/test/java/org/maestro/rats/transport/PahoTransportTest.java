package org.maestro.rats.transport;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.maestro.rats.broker.TestBroker;
import org.maestro.rats.security.LogLines;

class PahoTransportTest extends PahoTransportContract {
  private final TestBroker broker = TestBroker.embedded();

  @Override
  TestBroker broker() {
    return broker;
  }

  /** mosquitto 2.0.11 does not tell a client why it is dropped. */
  @Test
  void thatAnotherHasItsClientIdIsSaidOnceAndNothingWhenTheBrokerIsAway() {
    try (LogLines log = LogLines.of(PahoTransport.class.getName())) {
      Counting counting = new Counting(new AtomicInteger(), new AtomicInteger());
      Transport one = client("twin");
      one.open(Optional.empty(), counting);
      await(() -> counting.connections().get() == 1);
      stopBroker();
      await(() -> counting.losses().get() > 0);
      restartBroker();
      await(() -> counting.connections().get() == 2);
      assertThat(log.lines()).noneMatch(line -> line.contains(one.clientId()));

      for (int times = 3; times <= 5; times++) {
        int connections = times;
        PahoConnection rival =
            new PahoConnection(
                broker.uri(),
                one.clientId(),
                Duration.ofSeconds(15),
                Optional.empty(),
                Optional.empty(),
                new Silent());
        rival.connect();
        await(() -> counting.connections().get() == connections);
        rival.cut();
      }
      one.close();

      assertThat(log.lines())
          .filteredOn(line -> line.contains(one.clientId()))
          .containsExactly(
              "Another client connects to %s as %s too, so that the broker drops this one; give it a client id of its own."
                  .formatted(broker.uri(), one.clientId()));
    }
  }

  /** Counts connections, and those that were lost or did not come about. */
  private record Counting(AtomicInteger connections, AtomicInteger losses)
      implements Transport.ConnectionListener {
    @Override
    public void connected() {
      connections.incrementAndGet();
    }

    @Override
    public void lost(String reason) {
      losses.incrementAndGet();
    }
  }

  /** Of the rival only that it connects matters. */
  private static final class Silent implements PahoConnection.Events {
    @Override
    public void established(PahoConnection connection, int receiveMaximum) {
      // The other one hears of it.
    }

    @Override
    public void ended(PahoConnection connection, String reason) {
      // It is not to come back.
    }

    @Override
    public void arrived(PahoConnection connection, Message message) {
      // It subscribes to nothing.
    }
  }
}
