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

  @Test
  void aSlowClientIsHeardLaterAndInOrder() {
    List<String> arrivals = new ArrayList<>();
    Transport reader = bus.client("reader");
    reader.subscribe(
        "a",
        Transport.RetainedMessages.SEND,
        message -> arrivals.add(clock.now().toMillis() + " " + message.payload().length));
    reader.open(Optional.empty(), new Silent());
    clock.run(Duration.ofMillis(10));
    bus.slow("reader", Duration.ofMillis(100));
    reader.publish(Publication.stream("a", new byte[1]), failure -> {});
    bus.slow("reader", Duration.ZERO);
    reader.publish(Publication.stream("a", new byte[2]), failure -> {});
    clock.run(Duration.ofMillis(200));
    assertThat(arrivals).containsExactly("111 1", "111 2");
  }

  @Test
  void aClientThatWasCutOffLeavesItsWillAndComesBackWhenMended() {
    List<Integer> wills = new ArrayList<>();
    List<Duration> connects = new ArrayList<>();
    Transport reader = bus.client("reader");
    reader.subscribe(
        "will", Transport.RetainedMessages.SEND, message -> wills.add(message.payload().length));
    reader.open(Optional.empty(), new Silent());
    Transport client = bus.client("client");
    client.open(
        Optional.of(new Transport.Will("will", new byte[3])),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            connects.add(clock.now());
          }

          @Override
          public void lost(String reason) {
            connects.add(Duration.ZERO);
          }
        });
    clock.run(Duration.ofMillis(10));
    bus.cut("client");
    clock.run(Duration.ofMillis(990));
    bus.mend("client");
    clock.run(Duration.ofMillis(10));
    assertThat(wills).containsExactly(3);
    assertThat(connects)
        .containsExactly(Duration.ofMillis(1), Duration.ZERO, Duration.ofMillis(1001));
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
