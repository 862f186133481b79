package org.maestro.rats.member;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;
import org.maestro.rats.transport.Transport.RetainedMessages;

/** A member of the in-process bus, and a caller that notes what it hears of it. */
abstract class MemberOnABus {

  final SteppedClock clock = new SteppedClock();
  final InProcessBus bus = new InProcessBus(clock);
  final Topics topics = new Topics("test");
  final WireFormat wire = new WireFormat();
  final TestDevice device = new TestDevice("rose", clock);
  final Transport caller = bus.client("cca");
  final List<Result> results = new ArrayList<>();
  final List<Duration> resultTimes = new ArrayList<>();
  final List<Progress> progress = new ArrayList<>();
  final List<String> observations = new ArrayList<>();
  final List<Call> calls = new ArrayList<>();
  final List<String> retained = new ArrayList<>();
  Optional<MemberState> state = Optional.empty();

  /** Each state that it told, with the clock's seconds. */
  final List<String> timeline = new ArrayList<>();

  RatsMember member;

  @BeforeEach
  void join() {
    caller.subscribe(
        topics.results("cca"),
        RetainedMessages.SEND,
        message -> {
          results.add(wire.decodeResult(message.payload()));
          resultTimes.add(clock.now());
        });
    caller.subscribe(
        topics.progresses("cca"),
        RetainedMessages.SEND,
        message -> progress.add(wire.decodeProgress(message.payload())));
    caller.subscribe(
        topics.observations(),
        RetainedMessages.SEND,
        message -> {
          var observation = wire.decodeObservation(message.payload());
          observations.add(observation.id() + observation.values());
        });
    caller.subscribe(
        topics.statuses(),
        RetainedMessages.SEND,
        message ->
            retained.add(
                message.payload().length == 0
                    ? "status cleared"
                    : wire.decodeStatus(message.payload()).phase().name()));
    caller.subscribe(
        topics.descriptions(),
        RetainedMessages.SEND,
        message -> retained.add("description " + new String(message.payload(), UTF_8)));
    caller.subscribe(
        topics.states(),
        RetainedMessages.SEND,
        message -> {
          state =
              message.payload().length == 0
                  ? Optional.empty()
                  : Optional.of(wire.decodeState(message.payload()));
          state.ifPresent(told -> timeline.add(clock.now().toSeconds() + " " + told.state()));
        });
    caller.open(Optional.empty(), new Unconcerned());
    run(1);
    start();
  }

  MemberProfile profile() {
    return device.profile();
  }

  void start() {
    member = RatsMember.start(profile(), () -> device.facts, bus.client("rose"), "test", clock);
    run(1);
  }

  Result only() {
    assertThat(results).hasSize(1);
    return results.get(0);
  }

  static void assertRejected(Result result, ErrorCode code) {
    assertThat(result.outcome()).isEqualTo(Outcome.REJECTED);
    assertThat(result.error().orElseThrow().code()).isEqualTo(code);
  }

  static Result succeeded(String id, Map<String, Object> values) {
    return new Result(id, "rose", Outcome.SUCCEEDED, "standby", values, Optional.empty());
  }

  static Map<String, Object> pointer(String iri, double position) {
    Map<String, Object> pointer = new LinkedHashMap<>();
    pointer.put("ref", iri);
    pointer.put("position", List.of(position, 0.0, 0.0));
    return pointer;
  }

  static Call call(String id, String feature, Map<String, Object> parameters) {
    return new Call(
        id,
        Optional.of("rose"),
        Optional.empty(),
        feature,
        parameters,
        Duration.ofMinutes(10),
        "cca",
        Optional.empty());
  }

  static Call with(Call call, Optional<String> receiver) {
    return new Call(
        call.id(),
        receiver,
        call.boot(),
        call.feature(),
        call.parameters(),
        call.timeout(),
        call.from(),
        call.task());
  }

  static Call with(Call call, Duration timeout) {
    return new Call(
        call.id(),
        call.member(),
        call.boot(),
        call.feature(),
        call.parameters(),
        timeout,
        call.from(),
        call.task());
  }

  static Call with(Call call, String boot) {
    return new Call(
        call.id(),
        call.member(),
        Optional.of(boot),
        call.feature(),
        call.parameters(),
        call.timeout(),
        call.from(),
        call.task());
  }

  void send(Call call) {
    publish(
        Publication.reliable(topics.call("cca"), wire.encode(call), Optional.of(call.timeout())));
  }

  void publish(Publication publication) {
    caller.publish(publication, failure -> assertThat(failure).isEmpty());
  }

  void run(int seconds) {
    clock.run(Duration.ofSeconds(seconds));
  }

  static final class Unconcerned implements Transport.ConnectionListener {
    @Override
    public void connected() {
      // The tests look at messages.
    }

    @Override
    public void lost(String reason) {
      // The tests look at messages.
    }
  }
}
