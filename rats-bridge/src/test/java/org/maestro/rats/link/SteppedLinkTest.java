package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Transport;

class SteppedLinkTest extends LinkContract {

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);

  @Override
  Clock clock() {
    return clock;
  }

  @Override
  Transport client(String id) {
    return bus.client(id);
  }

  @Override
  int seeds() {
    return 100;
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
    assertThat(clock.runUntil(condition, Duration.ofMinutes(2))).isTrue();
  }

  @Test
  void isTheSameInEveryRun() {
    String first = exchange();
    assertThat(first).contains("SUCCEEDED").contains("TIMED_OUT").contains("CostAnswer");
    for (int round = 0; round < 5; round++) {
      assertThat(exchange()).isEqualTo(first);
    }
  }

  @Test
  void aMemberHasItsGraceBeyondTheTimeOfTheCall() {
    Stranger stranger = new Stranger("odd");
    assertThat(silentFor(Optional.empty())).isBetween(Duration.ofSeconds(5), Duration.ofSeconds(9));
    assertThat(silentFor(Optional.of(Duration.ofSeconds(40))))
        .isBetween(Duration.ofSeconds(40), Duration.ofSeconds(44));
    assertThat(stranger.calls).hasSize(2);
  }

  /** How long it is waited for one that says nothing to a call of 0.3 s. */
  private Duration silentFor(Optional<Duration> grace) {
    RatsLink link = connect("cca-" + grace.isPresent(), SITE);
    await(() -> usable(link, "odd"));
    Listener listener = new Listener();
    Duration begun = clock.now();
    link.call(
        new RatsLink.Order(
            Optional.empty(),
            "odd",
            Optional.empty(),
            "measure",
            Map.of(),
            Duration.ofMillis(300),
            grace,
            Optional.empty(),
            Optional.empty()),
        listener);
    await(listener::ended);
    return clock.now().minus(begun);
  }

  private static String exchange() {
    SteppedClock own = new SteppedClock();
    InProcessBus ownBus = new InProcessBus(own);
    List<String> log = new ArrayList<>();
    for (String id : List.of("rose", "anna", "tim")) {
      RatsMember.start(
          new TestDevice(id, own).profile(), () -> List.of("(a b)"), ownBus.client(id), "s", own);
    }
    RatsLink link = BusLink.connect("cca", "s", ownBus.client("cca"), own);
    link.watch(member -> log.add(own.now() + " " + member));
    own.run(Duration.ofSeconds(1));
    for (String id : List.of("tim", "rose", "anna")) {
      link.cost(id, "drive", List.of(Map.of()), costs -> log.add(own.now() + " " + costs));
      for (int timeout = 1; timeout < 10; timeout++) {
        link.call(
            id,
            timeout % 2 == 0 ? "drive" : "wave",
            Map.of("to", "a"),
            Duration.ofSeconds(timeout),
            Optional.empty(),
            result -> log.add(own.now() + " " + result));
      }
    }
    own.run(Duration.ofMinutes(1));
    return String.join("\n", log);
  }
}
