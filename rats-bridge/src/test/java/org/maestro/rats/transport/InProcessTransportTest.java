package org.maestro.rats.transport;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.maestro.rats.time.SteppedClock;

class InProcessTransportTest extends TransportContract {

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);

  @Override
  Transport client(String id) {
    return bus.client(id);
  }

  @Override
  void stopBroker() {
    bus.stop();
  }

  @Override
  void restartBroker() {
    bus.restart();
  }

  @Override
  void await(BooleanSupplier condition) {
    assertThat(clock.runUntil(condition, Duration.ofSeconds(5))).isTrue();
  }

  @Test
  void takesOneMillisecondForEachMessage() {
    List<Duration> arrivals = new ArrayList<>();
    Transport reader = bus.client("reader");
    reader.subscribe("a", Transport.RetainedMessages.SEND, message -> arrivals.add(clock.now()));
    reader.open(Optional.empty(), new Silent());
    clock.run(Duration.ofMillis(10));
    reader.publish(Publication.stream("a", new byte[0]), failure -> {});
    clock.run(Duration.ofMillis(10));
    assertThat(arrivals).containsExactly(Duration.ofMillis(11));
  }

  @Test
  void forgetsRetainedMessagesThatExpired() {
    List<Message> arrivals = new ArrayList<>();
    Transport client = bus.client("client");
    client.open(Optional.empty(), new Silent());
    clock.run(Duration.ofMillis(10));
    client.publish(
        new Publication(
            "a",
            new byte[1],
            Publication.Quality.AT_LEAST_ONCE,
            true,
            Optional.of(Duration.ofSeconds(2))),
        failure -> {});
    clock.run(Duration.ofSeconds(3));
    client.subscribe("a", Transport.RetainedMessages.SEND, arrivals::add);
    clock.run(Duration.ofSeconds(1));
    assertThat(arrivals).isEmpty();
  }

  private static final class Silent implements Transport.ConnectionListener {
    @Override
    public void connected() {
      // What is published is what counts here.
    }

    @Override
    public void lost(String reason) {
      // Nobody is lost here.
    }
  }
}
