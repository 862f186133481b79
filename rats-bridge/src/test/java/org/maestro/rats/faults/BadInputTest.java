package org.maestro.rats.faults;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.spi.ILoggingEvent;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.security.LogLines;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;

/** Broken messages on every topic, and valid calls between them. */
@Isolated("other tests start threads and write to the log")
class BadInputTest {

  private static final int BETWEEN = 20;

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final Topics topics = new Topics("home");
  private final WireFormat wire = new WireFormat();
  private final CountingDevice device = new CountingDevice("rose", clock, Duration.ofMillis(5));
  @AutoClose private final LogLines log = LogLines.of("org.maestro.rats");

  @Test
  void aThousandBrokenMessagesStopNobody() {
    survives(1_000);
  }

  @Test
  @Tag("full")
  void aHundredThousandBrokenMessagesStopNobody() {
    survives(100_000);
  }

  private void survives(int broken) {
    Random chance = new Random(11);
    Mutations mutations = new Mutations(chance);
    RatsMember member =
        RatsMember.start(device.profile(), List::of, bus.client("rose"), "home", clock);
    RatsLink link = BusLink.connect("cca", "home", bus.client("cca"), clock);
    Vandal vandal = Vandal.join(bus, topics, clock);
    List<Publication> samples = samples(member.boot());
    List<Outcomes> calls = new ArrayList<>();
    for (int number = 0; number < broken; number++) {
      Publication valid = samples.get(chance.nextInt(samples.size()));
      vandal.publish(
          new Publication(
              valid.topic(),
              mutations.of(valid.payload()),
              valid.quality(),
              valid.retained(),
              valid.expiry()));
      if (number % BETWEEN == 0) {
        Outcomes outcomes = new Outcomes();
        calls.add(outcomes);
        link.call(
            "rose",
            "deed",
            Map.of("n", number),
            Duration.ofSeconds(30),
            Optional.empty(),
            outcomes);
        clock.run(Duration.ofMillis(20));
      }
    }
    clock.run(Duration.ofSeconds(60));
    assertThat(calls)
        .allSatisfy(
            call ->
                assertThat(call.results)
                    .singleElement()
                    .extracting(Result::outcome)
                    .isEqualTo(Outcome.SUCCEEDED));
    List<ILoggingEvent> loud =
        log.events().stream()
            .filter(event -> event.getLevel().isGreaterOrEqual(Level.WARN))
            .toList();
    // Each of the two listeners knows the vandal, the ghost, the phantom and the bare topics.
    assertThat(loud).as(loud.toString()).hasSizeBetween(1, 12);
    assertThat(loud).noneMatch(event -> event.getThrowableProxy() != null);
  }

  /** One valid message for each topic; what members say of themselves is said of another. */
  private List<Publication> samples(String boot) {
    Call call =
        new Call(
            "v1",
            Optional.of("rose"),
            Optional.of(boot),
            "deed",
            Map.of("object", Map.of("ref", "urn:x#y", "position", List.of(1.0, 2.0))),
            Duration.ofSeconds(9),
            "vandal",
            Optional.of("G1"));
    Map<String, Object> values = Map.of("a", 1, "b", List.of("x", true));
    Result result =
        new Result("v1", "ghost", Outcome.SUCCEEDED, "standby", values, Optional.empty());
    return List.of(
        live(topics.call("vandal"), wire.encode(call)),
        live(topics.calls().replace("/#", ""), wire.encode(call)),
        live(topics.result("cca", "ghost"), wire.encode(result)),
        live(topics.bareResult(), wire.encode(result)),
        live(
            topics.progress("cca", "ghost"),
            wire.encode(new Progress("v1", "ghost", Progress.Kind.RUNNING, 0.5, values))),
        live(
            topics.observation("ghost", "scan"),
            wire.encode(new Observation("v1", "ghost", "scan", values))),
        Publication.retained(
            topics.status("ghost"),
            wire.encode(new MemberStatus("ghost", MemberStatus.Phase.READY, "b"))),
        Publication.retained(
            topics.state("ghost"),
            wire.encode(
                new MemberState(
                    "ghost", "b", "z", List.of("(a b)"), List.of(), List.of(), List.of()))),
        Publication.retained(
            topics.controllerStatus("phantom"),
            wire.encode(new MemberStatus("phantom", MemberStatus.Phase.READY, "b"))));
  }

  private static Publication live(String topic, byte[] payload) {
    return Publication.reliable(topic, payload, Optional.of(Duration.ofSeconds(9)));
  }
}
