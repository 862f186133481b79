package org.maestro.rats.member;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
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

class RatsMemberTest {

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final Topics topics = new Topics("test");
  private final WireFormat wire = new WireFormat();
  private final TestDevice device = new TestDevice("rose", clock);
  private final Transport caller = bus.client("cca");
  private final List<Result> results = new ArrayList<>();
  private final List<Duration> resultTimes = new ArrayList<>();
  private final List<Progress> progress = new ArrayList<>();
  private final List<String> observations = new ArrayList<>();
  private final List<String> retained = new ArrayList<>();
  private Optional<MemberState> state = Optional.empty();
  private RatsMember member;

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
        message ->
            state =
                message.payload().length == 0
                    ? Optional.empty()
                    : Optional.of(wire.decodeState(message.payload())));
    caller.open(Optional.empty(), new Unconcerned());
    run(1);
    start();
  }

  private void start() {
    member =
        RatsMember.start(device.profile(), () -> device.facts, bus.client("rose"), "test", clock);
    run(1);
  }

  @Test
  void announcesItself() {
    assertThat(retained).containsExactly("INIT", "description {\"@id\":\"rose\"}", "READY");
    assertThat(state.orElseThrow())
        .isEqualTo(
            new MemberState(
                "rose",
                member.boot(),
                "standby",
                List.of("(level lamp 0)"),
                List.of(),
                List.of(),
                List.of()));
  }

  @Test
  void executesACallForIt() {
    send(call("c1", "drive", Map.of("to", "zone-a")));
    run(5);
    assertThat(results).containsExactly(succeeded("c1", Map.of()));
    assertThat(progress)
        .extracting(Progress::kind)
        .containsExactly(Progress.Kind.ACCEPTED, Progress.Kind.STARTED);
    assertThat(resultTimes).containsExactly(Duration.ofMillis(4002));
  }

  @Test
  void takesBlankCallsOfItsFeaturesAndNoOthers() {
    send(with(call("c1", "echo", Map.of("a", 1)), Optional.empty()));
    send(with(call("c2", "fly", Map.of()), Optional.empty()));
    send(with(call("c3", "echo", Map.of()), Optional.of("tim")));
    send(with(call("c4", "fly", Map.of()), Optional.of("rose")));
    run(1);
    assertThat(results).hasSize(2);
    assertThat(results.get(0)).isEqualTo(succeeded("c1", Map.of("a", 1)));
    assertRejected(results.get(1), ErrorCode.UNKNOWN_FEATURE);
  }

  @Test
  void asksForRequiredParameters() {
    send(call("c1", "drive", Map.of()));
    run(1);
    assertRejected(only(), ErrorCode.INVALID_PARAMETERS);
    assertThat(only().error().orElseThrow().message()).contains("to");
  }

  @Test
  void queuesCallsForOccupiedComponentsInTheirOrder() {
    send(call("c1", "drive", Map.of("to", "a")));
    send(call("c2", "grip", Map.of()));
    send(call("c3", "wave", Map.of()));
    send(call("c4", "echo", Map.of()));
    run(1);
    MemberState busy = state.orElseThrow();
    assertThat(busy.state()).isEqualTo("busy");
    assertThat(busy.running()).containsExactly("c1");
    assertThat(busy.queue()).containsExactly("c2", "c3");
    run(10);
    assertThat(results).extracting(Result::id).containsExactly("c4", "c1", "c2", "c3");
    assertThat(device.log)
        .containsExactly(
            "2 start drive",
            "2 start echo",
            "4 end drive",
            "4 start grip",
            "6 end grip",
            "6 start wave",
            "7 end wave");
    assertThat(state.orElseThrow().state()).isEqualTo("standby");
  }

  @Test
  void runsCallsOfDifferentComponentsTogether() {
    send(call("c1", "drive", Map.of("to", "a")));
    send(call("c2", "wave", Map.of()));
    run(5);
    assertThat(results).extracting(Result::id).containsExactly("c2", "c1");
  }

  @Test
  void timesOutInTheQueue() {
    send(call("c1", "drive", Map.of("to", "a")));
    send(with(call("c2", "drive", Map.of("to", "b")), Duration.ofSeconds(1)));
    run(10);
    assertThat(results).extracting(Result::id).containsExactly("c2", "c1");
    assertThat(results.get(0).outcome()).isEqualTo(Outcome.TIMED_OUT);
    assertThat(results.get(0).error().orElseThrow().code()).isEqualTo(ErrorCode.TIMEOUT);
    assertThat(device.log).hasSize(2);
  }

  @Test
  void timesOutThroughTheExitStrategyWhenRunning() {
    send(with(call("c1", "grip", Map.of()), Duration.ofMillis(500)));
    send(call("c2", "wave", Map.of()));
    run(10);
    assertThat(device.log).startsWith("2 start grip", "4 end grip", "5 put down", "5 start wave");
    assertThat(results).extracting(Result::id).containsExactly("c1", "c2");
    assertThat(results.get(0).outcome()).isEqualTo(Outcome.TIMED_OUT);
    assertThat(results.get(0).state()).isEqualTo("standby");
  }

  @Test
  void isCancelledByCall() {
    send(call("c1", "grip", Map.of()));
    send(call("c2", "drive", Map.of("to", "a")));
    run(1);
    send(call("x1", "$cancel", Map.of("id", "c2")));
    send(call("x2", "$cancel", Map.of("id", "c1")));
    send(call("x3", "$cancel", Map.of("id", "c9")));
    run(10);
    assertThat(results)
        .extracting(result -> result.id() + " " + result.outcome())
        .containsExactly(
            "c2 CANCELED", "x1 SUCCEEDED", "x2 SUCCEEDED", "x3 SUCCEEDED", "c1 CANCELED");
    assertThat(results.get(3).values()).isEqualTo(Map.of("found", false));
    assertThat(device.log).contains("6 put down");
  }

  @Test
  void becomesSafeWhenTold() {
    member.rest("holding");
    send(call("c1", "grip", Map.of()));
    send(call("c2", "grip", Map.of()));
    run(1);
    send(with(call("s1", "$safe", Map.of()), Optional.empty()));
    run(10);
    assertThat(results)
        .extracting(result -> result.id() + " " + result.outcome())
        .containsExactly("c2 CANCELED", "c1 CANCELED", "s1 SUCCEEDED");
    assertThat(results.get(2).state()).isEqualTo("standby");
    assertThat(state.orElseThrow().state()).isEqualTo("standby");
  }

  @Test
  void answersTheSameCallAgainWithoutExecutingItTwice() {
    Call call = call("c1", "echo", Map.of("a", 1));
    send(call);
    run(1);
    send(call);
    run(1);
    assertThat(results).containsExactly(succeeded("c1", Map.of("a", 1)), results.get(0));
    assertThat(device.log).hasSize(1);
    send(call("c1", "echo", Map.of("a", 2)));
    run(1);
    assertRejected(results.get(2), ErrorCode.DUPLICATE_ID);
    send(call);
    run(1);
    assertThat(results.get(3)).isEqualTo(results.get(0));
    run(3600);
    send(call);
    run(1);
    assertThat(device.log).as("after the memory has run out").hasSize(2);
  }

  @Test
  void tellsAgainHowFarACallIsThatItHasAlready() {
    Call drive = call("c1", "drive", Map.of("to", "a"));
    Call queued = call("c2", "drive", Map.of("to", "b"));
    Call watch = call("c3", "watch", Map.of("object", "Cup"));
    send(drive);
    send(queued);
    send(watch);
    clock.run(Duration.ofMillis(1500));
    progress.clear();
    send(drive);
    send(queued);
    send(watch);
    clock.run(Duration.ofMillis(100));
    assertThat(progress)
        .extracting(Progress::kind)
        .containsExactly(Progress.Kind.STARTED, Progress.Kind.ACCEPTED, Progress.Kind.ESTABLISHED);
    assertThat(progress.get(2).values()).as("the latest ones").containsEntry("n", 1);
    run(10);
    assertThat(results).extracting(Result::id).containsExactly("c1", "c2");
    assertThat(device.log).filteredOn(line -> line.contains("start")).hasSize(3);
  }

  @Test
  void remembersACallAsLongAsItIsUnderWayAndTenMinutesMore() {
    Call watch = call("c1", "watch", Map.of("object", "Cup"));
    send(watch);
    run(3600);
    send(watch);
    run(1);
    assertThat(device.log).hasSize(1);
    send(call("c2", "unwatch", Map.of("object", "Cup")));
    run(590);
    for (int question = 0; question < 5000; question++) {
      send(call("q" + question, "$ping", Map.of()));
    }
    run(1);
    send(watch);
    run(1);
    assertThat(device.log).as("one watch, one unwatch").hasSize(2);
  }

  @Test
  void refusesCallsForAFormerLife() {
    String formerBoot = member.boot();
    member.die();
    run(1);
    start();
    assertThat(retained)
        .containsSubsequence("LOST", "INIT", "description {\"@id\":\"rose\"}", "READY")
        .endsWith("READY");
    send(with(call("c1", "echo", Map.of()), formerBoot));
    send(with(call("c2", "echo", Map.of()), member.boot()));
    run(1);
    assertRejected(results.get(0), ErrorCode.RESTARTED);
    assertThat(results.get(1).outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  @Test
  void neverExecutesARetainedCall() {
    publish(Publication.retained(topics.call("cca"), wire.encode(call("c1", "echo", Map.of()))));
    run(1);
    member.die();
    start();
    assertThat(device.log).isEmpty();
    assertThat(results).isEmpty();
  }

  @Test
  void doesNotExecuteWhatHasExpired() {
    Call late = with(call("c1", "drive", Map.of("to", "a")), Duration.ofSeconds(20));
    publish(
        Publication.reliable(
            topics.call("cca"), wire.encode(late), Optional.of(Duration.ofMillis(5))));
    run(5);
    assertThat(only().outcome())
        .as("what is left of the expiry counts, not t")
        .isEqualTo(Outcome.TIMED_OUT);
  }

  @Test
  void ignoresCallsInTheNameOfOthers() {
    publish(
        Publication.reliable(
            topics.call("thief"), wire.encode(call("c1", "echo", Map.of())), Optional.empty()));
    run(1);
    assertThat(device.log).isEmpty();
  }

  @Test
  void refusesMalformedCallsForItOnly() {
    String forRose = "{\"v\":\"1.0\",\"id\":\"c1\",\"r\":\"rose\",\"f\":\"echo\",\"from\":\"cca\"}";
    for (String text :
        List.of(forRose, forRose.replace("rose", "tim"), "{}", forRose.replace("1.0", "2.0"))) {
      publish(Publication.reliable(topics.call("cca"), text.getBytes(UTF_8), Optional.empty()));
    }
    run(1);
    assertThat(results).hasSize(2);
    assertRejected(results.get(0), ErrorCode.MALFORMED);
    assertRejected(results.get(1), ErrorCode.UNSUPPORTED_VERSION);
  }

  @Test
  void streamsUntilItsEndingFeatureNamesTheSameObject() {
    Map<String, Object> cup = pointer("urn:Cup", 1.0);
    send(with(call("c1", "watch", Map.of("object", cup)), Duration.ofSeconds(2)));
    send(call("c2", "watch", Map.of("object", "Ball")));
    clock.run(Duration.ofMillis(2500));
    send(call("e1", "unwatch", Map.of("object", pointer("urn:Cup", 2.0))));
    run(2);
    assertThat(observations)
        .containsExactly("c1{n=1}", "c2{n=1}", "c1{n=2}", "c2{n=2}", "c2{n=3}", "c2{n=4}");
    assertThat(progress)
        .filteredOn(sign -> sign.kind() == Progress.Kind.ESTABLISHED)
        .extracting(sign -> sign.id() + sign.values())
        .containsExactly("c1{n=0}", "c2{n=0}");
    assertThat(results)
        .extracting(result -> result.id() + " " + result.outcome())
        .containsExactly("c1 SUCCEEDED", "e1 SUCCEEDED");
    send(call("x1", "$cancel", Map.of("id", "c2")));
    run(1);
    assertThat(results.get(2).outcome()).isEqualTo(Outcome.CANCELED);
  }

  @Test
  void tellsItsPrices() {
    Map<String, Object> parameters = new LinkedHashMap<>();
    parameters.put("feature", "drive");
    parameters.put("sets", List.of(Map.of("to", "a"), Map.of("to", "b")));
    send(call("c1", "$cost", parameters));
    send(call("c2", "$cost", Map.of("feature", "fly", "sets", List.of())));
    send(call("c3", "$cost", Map.of()));
    run(1);
    Map<String, Object> price = Map.of("cost", 2.5, "seconds", 2.0);
    assertThat(results.get(0).values()).isEqualTo(Map.of("costs", List.of(price, price)));
    assertRejected(results.get(1), ErrorCode.UNKNOWN_FEATURE);
    assertRejected(results.get(2), ErrorCode.INVALID_PARAMETERS);
    assertThat(state.orElseThrow().running()).isEmpty();
  }

  @Test
  void describesItselfAndAnswersPings() {
    retained.clear();
    send(call("c1", "$describe", Map.of()));
    send(call("c2", "$ping", Map.of()));
    run(1);
    assertThat(retained).containsExactly("description {\"@id\":\"rose\"}", "READY");
    assertThat(results).extracting(Result::outcome).containsOnly(Outcome.SUCCEEDED).hasSize(2);
  }

  @Test
  void refusesDisabledFeatures() {
    member.disable("grip", "the hand is full");
    run(1);
    assertThat(state.orElseThrow().disabled()).containsExactly("grip");
    send(call("c1", "grip", Map.of()));
    run(1);
    assertRejected(only(), ErrorCode.DISABLED);
    assertThat(only().error().orElseThrow().message()).isEqualTo("the hand is full");
    member.enable("grip");
    send(call("c2", "grip", Map.of()));
    run(5);
    assertThat(results.get(1).outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  @Test
  void boundsItsQueue() {
    for (int number = 0; number < 70; number++) {
      send(call("c" + number, "drive", Map.of("to", "a")));
    }
    run(1);
    assertThat(results).hasSize(5);
    assertThat(results).allSatisfy(result -> assertRejected(result, ErrorCode.QUEUE_FULL));
  }

  @Test
  void reportsABrokenProcedure() {
    send(call("c1", "broken", Map.of()));
    run(1);
    assertThat(only().outcome()).isEqualTo(Outcome.FAILED);
    assertThat(only().error().orElseThrow().code()).isEqualTo(ErrorCode.INTERNAL);
  }

  @Test
  void tellsEachChangeOfItsFacts() {
    device.facts.set(0, "(level lamp 1)");
    member.stateChanged();
    member.stateChanged();
    run(1);
    assertThat(state.orElseThrow().values()).containsExactly("(level lamp 1)");
    assertThatThrownBy(() -> member.rest("flying")).hasMessageContaining("flying");
  }

  @Test
  void publishesAgainWhenTheBusComesBackEmpty() {
    send(call("c1", "drive", Map.of("to", "a")));
    run(1);
    bus.stop();
    run(5);
    retained.clear();
    state = Optional.empty();
    bus.restart();
    run(1);
    assertThat(retained).containsExactly("description {\"@id\":\"rose\"}", "READY");
    assertThat(state).isPresent();
    assertThat(results).as("the result that could not be sent").hasSize(1);
  }

  @Test
  void doesNotLetALateWillBeTheLastWord() {
    retained.clear();
    publish(
        Publication.retained(
            topics.status("rose"),
            "{\"v\":\"1.0\",\"id\":\"rose\",\"status\":\"lost\",\"boot\":\"old\"}"
                .getBytes(UTF_8)));
    run(1);
    assertThat(retained).containsExactly("LOST", "READY");
  }

  @Test
  void clearsWhatIsRetainedWhenItLeaves() {
    send(call("c1", "drive", Map.of("to", "a")));
    run(1);
    retained.clear();
    member.close();
    run(10);
    assertThat(retained).containsExactly("description ", "status cleared");
    assertThat(state).isEmpty();
    assertThat(results).isEmpty();
  }

  @Test
  void isRefusedWithoutASafeState() {
    assertThatThrownBy(() -> new MemberProfile("rose", "", Set.of("a"), "a", Set.of(), Map.of()))
        .hasMessageContaining("safe state");
    assertThatThrownBy(() -> new MemberProfile("rose", "", Set.of("a"), "b", Set.of("a"), Map.of()))
        .hasMessageContaining("b");
    assertThatThrownBy(() -> new MemberProfile("a/b", "", Set.of("a"), "a", Set.of("a"), Map.of()))
        .hasMessageContaining("a/b");
  }

  private Result only() {
    assertThat(results).hasSize(1);
    return results.get(0);
  }

  private static void assertRejected(Result result, ErrorCode code) {
    assertThat(result.outcome()).isEqualTo(Outcome.REJECTED);
    assertThat(result.error().orElseThrow().code()).isEqualTo(code);
  }

  private static Result succeeded(String id, Map<String, Object> values) {
    return new Result(id, "rose", Outcome.SUCCEEDED, "standby", values, Optional.empty());
  }

  private static Map<String, Object> pointer(String iri, double position) {
    Map<String, Object> pointer = new LinkedHashMap<>();
    pointer.put("ref", iri);
    pointer.put("position", List.of(position, 0.0, 0.0));
    return pointer;
  }

  private static Call call(String id, String feature, Map<String, Object> parameters) {
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

  private static Call with(Call call, Optional<String> receiver) {
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

  private static Call with(Call call, Duration timeout) {
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

  private static Call with(Call call, String boot) {
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

  private void send(Call call) {
    publish(
        Publication.reliable(topics.call("cca"), wire.encode(call), Optional.of(call.timeout())));
  }

  private void publish(Publication publication) {
    caller.publish(publication, failure -> assertThat(failure).isEmpty());
  }

  private void run(int seconds) {
    clock.run(Duration.ofSeconds(seconds));
  }

  private static final class Unconcerned implements Transport.ConnectionListener {
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
