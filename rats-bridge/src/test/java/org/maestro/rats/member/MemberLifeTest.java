package org.maestro.rats.member;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.transport.Publication;

/** What a member tells of itself, remembers and forgets over its lives. */
class MemberLifeTest extends MemberOnABus {

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
  void itsStateNamesTheCallsThatAreOverTheLatestLast() {
    send(call("c1", "wave", Map.of()));
    send(call("c2", "grip", Map.of()));
    run(1);
    assertThat(state.orElseThrow().recent()).isEmpty();
    run(10);

    assertThat(state.orElseThrow().recent())
        .containsExactly(
            new MemberState.Ended("c1", Outcome.SUCCEEDED),
            new MemberState.Ended("c2", Outcome.SUCCEEDED));
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
        .containsExactlyInAnyOrder(
            Progress.Kind.STARTED, Progress.Kind.ACCEPTED, Progress.Kind.ESTABLISHED);
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

  /** A second device of its id, say, that was told to leave. */
  @Test
  void tellsAgainWhatAnotherClears() {
    retained.clear();
    publish(Publication.clearing(topics.status("rose")));
    run(1);
    assertThat(retained)
        .containsExactly("status cleared", "description {\"@id\":\"rose\"}", "READY");
    assertThat(state).isPresent();
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
}
