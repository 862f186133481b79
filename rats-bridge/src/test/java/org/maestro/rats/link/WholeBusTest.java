package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/**
 * Six members of one bus: blank calls (Three-layered architecture, 3.2.3; M57), each to each
 * (Three-layered architecture, 2; M9), who hears what (Three-layered architecture, 3.2.3; M60,
 * M62).
 */
class WholeBusTest {

  private static final String SITE = "test";
  private static final int MEMBERS = 6;

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final Topics topics = new Topics(SITE);
  private final WireFormat wire = new WireFormat();
  private final Map<String, TestDevice> devices = new LinkedHashMap<>();

  @BeforeEach
  void join() {
    for (int number = 1; number <= MEMBERS; number++) {
      String id = "lamp-" + number;
      TestDevice device = new TestDevice(id, clock);
      devices.put(id, device);
      RatsMember.start(device.profile(), List::of, bus.client(id), SITE, clock);
    }
    run(2);
  }

  @Test
  void allSixDoWhatOneBlankCallAsks() {
    Party cca = new Party("cca");
    cca.call("c1", Optional.empty(), "wave");
    run(3);

    assertThat(cca.results).hasSize(MEMBERS).allMatch(r -> r.outcome() == Outcome.SUCCEEDED);
    assertThat(cca.results).extracting(Result::from).containsExactlyElementsOf(devices.keySet());
    assertThat(devices.values()).allMatch(device -> device.log.size() == 2);
  }

  @Test
  void eachIsReachedByEach() {
    for (String from : devices.keySet()) {
      Party speaker = new Party(from, "speaks-for-" + from);
      for (String to : devices.keySet()) {
        speaker.call(from + "-" + to, Optional.of(to), "$ping");
      }
      run(1);
      assertThat(speaker.results)
          .extracting(Result::from)
          .containsExactlyInAnyOrderElementsOf(devices.keySet());
    }
  }

  @Test
  void resultsFailuresAndTimeoutsReachTheirCallerOnlyAndAMonitorHearsAll() {
    List<String> heard = new ArrayList<>();
    Transport monitor = bus.client("monitor");
    monitor.subscribe(
        "rats/1/" + SITE + "/#",
        Transport.RetainedMessages.IGNORE,
        message -> heard.add(message.topic()));
    monitor.open(Optional.empty(), new Unconcerned());
    Party cca = new Party("cca");
    Party other = new Party("other");
    cca.call("same", Optional.of("lamp-1"), "echo");
    cca.call("c2", Optional.of("lamp-1"), "broken");
    cca.call("c3", Optional.of("lamp-1"), "grip", Duration.ofMillis(500));
    other.call("same", Optional.of("lamp-2"), "echo");
    run(6);

    assertThat(cca.results)
        .extracting(result -> result.id() + " " + result.outcome())
        .containsExactly("same SUCCEEDED", "c2 FAILED", "c3 TIMED_OUT");
    assertThat(other.results)
        .extracting(result -> result.id() + " " + result.from())
        .containsExactly("same lamp-2");
    assertThat(heard.stream().filter(topic -> topic.contains("/call/"))).hasSize(4);
    assertThat(heard.stream().filter(topic -> topic.contains("/result/")))
        .containsOnly(topics.result("cca", "lamp-1"), topics.result("other", "lamp-2"))
        .hasSize(4);
  }

  private void run(int seconds) {
    clock.run(Duration.ofSeconds(seconds));
  }

  private static final class Unconcerned implements Transport.ConnectionListener {
    @Override
    public void connected() {
      // Messages are looked at.
    }

    @Override
    public void lost(String reason) {
      // Messages are looked at.
    }
  }

  /** Who calls, and hears what is for it. */
  private final class Party {
    private final String id;
    private final Transport transport;
    private final List<Result> results = new ArrayList<>();

    private Party(String id) {
      this(id, id);
    }

    private Party(String id, String client) {
      this.id = id;
      this.transport = bus.client(client);
      transport.subscribe(
          topics.results(id),
          Transport.RetainedMessages.IGNORE,
          message -> results.add(wire.decodeResult(message.payload())));
      transport.open(Optional.empty(), new Unconcerned());
      run(1);
    }

    private void call(String callId, Optional<String> member, String feature) {
      call(callId, member, feature, Duration.ofSeconds(30));
    }

    private void call(String callId, Optional<String> member, String feature, Duration timeout) {
      Call call =
          new Call(
              callId, member, Optional.empty(), feature, Map.of(), timeout, id, Optional.empty());
      transport.publish(
          Publication.reliable(topics.call(id), wire.encode(call), Optional.of(timeout)),
          failure -> assertThat(failure).isEmpty());
    }
  }
}
