package org.maestro.rats.member;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/**
 * Streams with their frequencies (Three-layered architecture, 3.2.2; M52), tasks given back
 * (Three-layered architecture, 3.2.1; M44), and a controller that is lost.
 */
class ContinuousFeaturesTest extends MemberOnABus {

  private final AtomicInteger readings = new AtomicInteger();

  @Override
  MemberProfile profile() {
    MemberProfile usual = device.profile();
    Map<String, MemberProfile.Feature> features = new LinkedHashMap<>(usual.features());
    add(features, "localise", new Frequency.Fixed(10), this::regularly);
    add(features, "scan", new Frequency.UpTo(5), this::regularly);
    add(features, "hurry", new Frequency.UpTo(2), this::often);
    return new MemberProfile(
        "rose",
        usual.description(),
        usual.states(),
        "standby",
        usual.safeStates(),
        features,
        new StateRules(Map.of(), Map.of(), Optional.empty(), Duration.ofSeconds(30)));
  }

  private interface Start {
    void start(Execution execution);
  }

  private static void add(
      Map<String, MemberProfile.Feature> features, String id, Frequency frequency, Start start) {
    Procedure procedure =
        new Procedure() {
          @Override
          public void start(Execution execution) {
            start.start(execution);
          }

          @Override
          public CostAnswer cost(Map<String, Object> parameters) {
            return new CostAnswer(Optional.of(1.0), Optional.of(1.0), Optional.empty());
          }
        };
    features.put(
        id,
        new MemberProfile.Feature(
            id, Set.of(), Set.of(), true, Optional.empty(), "busy", procedure, frequency));
  }

  private void regularly(Execution execution) {
    execution.observeRegularly(() -> Map.of("n", readings.incrementAndGet()));
  }

  /** Tells a value each 10 ms. */
  private void often(Execution execution) {
    execution.established(Map.of("n", 0));
    again(execution);
  }

  private void again(Execution execution) {
    clock.schedule(
        Duration.ofMillis(10),
        "rose",
        () -> {
          if (!execution.ended()) {
            execution.observed(Map.of("n", readings.incrementAndGet()));
            again(execution);
          }
        });
  }

  private long heard(String id) {
    return observations.stream().filter(text -> text.startsWith(id + "{")).count();
  }

  /** The calls' ids tell which thing each value is of (Three-layered architecture, 4.3; M87). */
  @Test
  void oneStreamNamesTwoThingsUntilOneOfThemIsStopped() {
    List<String> stream = new ArrayList<>();
    caller.subscribe(
        topics.observation("rose", "watch"),
        Transport.RetainedMessages.IGNORE,
        message -> stream.add(wire.decodeObservation(message.payload()).id()));
    send(call("of-cup", "watch", Map.of("object", "Cup")));
    send(call("of-ball", "watch", Map.of("object", "Ball")));
    run(3);
    assertThat(stream).contains("of-cup", "of-ball");

    send(call("stop", "unwatch", Map.of("object", "Cup")));
    run(1);
    stream.clear();
    run(3);
    assertThat(stream).isNotEmpty().containsOnly("of-ball");
  }

  @Test
  void aFixedFrequencyCannotBeReduced() {
    send(call("c1", "localise", Map.of("frequency", 1)));
    run(10);
    assertThat(heard("c1")).isBetween(98L, 100L);
  }

  @Test
  void anUpperLimitCanBeReduced() {
    send(call("c1", "scan", Map.of()));
    send(call("c2", "scan", Map.of("frequency", 1)));
    send(call("c3", "scan", Map.of("frequency", 50)));
    run(10);
    assertThat(heard("c1")).isBetween(48L, 50L);
    assertThat(heard("c2")).isBetween(9L, 10L);
    assertThat(heard("c3")).as("no more than the limit").isBetween(48L, 50L);
  }

  @Test
  void whoTellsMoreThanTheLimitIsNotHeardMoreOften() {
    send(call("c1", "hurry", Map.of()));
    run(10);
    assertThat(heard("c1")).isBetween(19L, 21L);
  }

  @Test
  void whatIsNotRepeatableTellsNothingBesideItsResult() {
    send(call("c1", "drive", Map.of("to", "a")));
    run(10);
    assertThat(observations).isEmpty();
    assertThat(only().outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  @Test
  void severalRunAtOnceAndEachEndsByItself() {
    send(call("c1", "watch", Map.of("object", "cup")));
    send(call("c2", "watch", Map.of("object", "hat")));
    send(call("c3", "scan", Map.of()));
    run(5);
    assertThat(state.orElseThrow().running()).containsExactly("c1", "c2", "c3");
    send(call("u1", "unwatch", Map.of("object", "cup")));
    run(1);
    assertThat(state.orElseThrow().running()).containsExactly("c2", "c3");
  }

  /** Three-layered architecture, 3.2.1 (M44): acquiescence. */
  @Test
  void aTaskIsGivenBackBeforeItsTimeoutThroughTheExitStrategy() {
    caller.subscribe(
        topics.calls(),
        Transport.RetainedMessages.IGNORE,
        message -> calls.add(wire.decodeCall(message.payload())));
    device.gripFindsItselfJammed = true;
    send(call("c1", "grip", Map.of()));
    run(1);
    assertThat(calls)
        .filteredOn(call -> call.feature().equals("$release"))
        .singleElement()
        .satisfies(
            call -> {
              assertThat(call.member()).contains("cca");
              assertThat(call.parameters())
                  .containsEntry("task", "c1")
                  .containsEntry("reason", "the gripper is jammed");
            });
    assertThat(results).as("it puts down first").isEmpty();
    run(4);
    assertThat(only().outcome()).isEqualTo(Outcome.FAILED);
    assertThat(only().error().map(RatsError::message)).contains("the gripper is jammed");
    assertThat(only().state()).isEqualTo("standby");
    assertThat(device.log).anyMatch(line -> line.contains("put down"));
  }

  /**
   * Three-layered architecture, 2 (M16): what ends by itself ends by the local plan, what does not
   * is ended, then it rests.
   */
  @Test
  void aLostControllerStopsNothingThatRunsButWhatNobodyElseWouldEnd() {
    status(MemberStatus.Phase.READY);
    member.rest("holding");
    send(call("c1", "drive", Map.of("to", "a")));
    send(call("c2", "watch", Map.of("object", "cup")));
    run(1);
    status(MemberStatus.Phase.LOST);
    run(5);
    assertThat(only().id()).isEqualTo("c1");
    assertThat(only().outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(state.orElseThrow().running()).containsExactly("c2");
    run(30);
    assertThat(results.get(1).outcome()).isEqualTo(Outcome.CANCELED);
    assertThat(state.orElseThrow().running()).isEmpty();
    assertThat(state.orElseThrow().state()).isEqualTo("standby");
  }

  @Test
  void aControllerThatComesBackInTimeFindsItsStreams() {
    status(MemberStatus.Phase.READY);
    send(call("c2", "watch", Map.of("object", "cup")));
    run(1);
    status(MemberStatus.Phase.LOST);
    run(20);
    status(MemberStatus.Phase.READY);
    run(60);
    assertThat(state.orElseThrow().running()).containsExactly("c2");
  }

  private void status(MemberStatus.Phase phase) {
    publish(
        Publication.retained(
            topics.controllerStatus("cca"), wire.encode(new MemberStatus("cca", phase, "b1"))));
    run(0);
  }
}
