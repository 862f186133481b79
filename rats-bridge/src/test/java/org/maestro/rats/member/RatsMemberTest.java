package org.maestro.rats.member;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.transport.Publication;

/** Calls that a member hears, and what becomes of them. */
class RatsMemberTest extends MemberOnABus {

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
    assertThat(timeline.stream().distinct())
        .as("its states, and between two tasks it stands by")
        .containsExactly(
            "1 standby", "2 busy", "4 standby", "4 busy", "6 standby", "6 busy", "7 standby");
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
  void boundsItsQueue() {
    for (int number = 0; number < 70; number++) {
      send(call("c" + number, "drive", Map.of("to", "a")));
    }
    run(1);
    assertThat(results).hasSize(5);
    assertThat(results).allSatisfy(result -> assertRejected(result, ErrorCode.QUEUE_FULL));
  }

  @Test
  void isCancelledByACallerThatMeansItsOwnCallOfThatId() {
    send(call("c1", "grip", Map.of()));
    Call foreign =
        new Call(
            "c1",
            Optional.of("rose"),
            Optional.empty(),
            "wave",
            Map.of(),
            Duration.ofMinutes(10),
            "tim",
            Optional.empty());
    publish(Publication.reliable(topics.call("tim"), wire.encode(foreign), Optional.empty()));
    run(1);
    Call cancel =
        new Call(
            "x1",
            Optional.of("rose"),
            Optional.empty(),
            "$cancel",
            Map.of("id", "c1"),
            Duration.ofMinutes(10),
            "tim",
            Optional.empty());
    publish(Publication.reliable(topics.call("tim"), wire.encode(cancel), Optional.empty()));
    run(10);
    assertThat(only()).as("of the other caller").isEqualTo(succeeded("c1", Map.of()));
    assertThat(device.log).noneMatch(line -> line.contains("wave"));
  }

  @Test
  void reportsABrokenProcedure() {
    send(call("c1", "broken", Map.of()));
    run(1);
    assertThat(only().outcome()).isEqualTo(Outcome.FAILED);
    assertThat(only().error().orElseThrow().code()).isEqualTo(ErrorCode.INTERNAL);
  }
}
