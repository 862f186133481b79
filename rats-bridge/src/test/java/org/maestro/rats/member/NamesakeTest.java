package org.maestro.rats.member;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.link.MemberCalls;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;
import org.maestro.rats.transport.Transport.RetainedMessages;

/** What is said in a member's name by others ends it for as long as it is true, and no longer. */
class NamesakeTest extends MemberOnABus {

  /** Before every real one. */
  private static final String EARLIER = "0";

  private final List<MemberStatus> statuses = new ArrayList<>();

  @BeforeEach
  void listen() {
    Transport listener = client("listener");
    listener.subscribe(
        topics.status("rose"),
        RetainedMessages.SEND,
        message -> {
          if (message.payload().length > 0) {
            statuses.add(wire.decodeStatus(message.payload()));
          }
        });
    run(1);
  }

  @Test
  void aForgedStatusOfAnEarlierLifeEndsNobody() {
    send(call("c1", "grip", Map.of()));
    say(MemberStatus.Phase.READY);
    run(1);
    assertThat(member.isRefused()).isFalse();
    run(5);
    assertThat(only().outcome()).as("what ran meanwhile").isEqualTo(Outcome.SUCCEEDED);
    assertThatTheLastWordIsItsOwn();
    send(with(call("c2", "echo", Map.of()), member.boot()));
    run(1);
    assertThat(results.get(1).outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  @Test
  void norDoesOneThatIsRepeatedForHours() {
    for (int minute = 0; minute < 120; minute++) {
      say(minute % 2 == 0 ? MemberStatus.Phase.READY : MemberStatus.Phase.INIT);
      run(60);
      assertThat(member.isRefused()).isFalse();
    }
    assertThatTheLastWordIsItsOwn();
  }

  @Test
  void aForgedDescriptionIsNotTheLastWord() {
    for (String forged : List.of("{}", "rubbish", "")) {
      retained.clear();
      for (int time = 0; time < 50; time++) {
        publish(
            Publication.retained(
                topics.description("rose"), forged.getBytes(StandardCharsets.UTF_8)));
        clock.run(Duration.ofMillis(100));
      }
      run(2);
      assertThat(retained).last().isEqualTo("description {\"@id\":\"rose\"}");
      assertThat(retained).as("once a second").hasSizeBetween(52, 58);
    }
  }

  @Test
  void whoAsksAnswersNoCallsOfTheOtherLife() {
    say(MemberStatus.Phase.READY);
    run(1);
    send(with(call("c1", "echo", Map.of()), EARLIER));
    run(1);
    assertThat(results).as("while it may be another's").isEmpty();
    run(5);
    send(with(call("c2", "echo", Map.of()), EARLIER));
    run(1);
    assertRejected(only(), ErrorCode.RESTARTED);
  }

  @Test
  void comesBackWhenTheOtherDoesNotAnswerAnyMore() {
    OtherLife other = new OtherLife();
    send(call("c1", "grip", Map.of()));
    say(MemberStatus.Phase.READY);
    run(1);
    assertThat(member.isRefused()).isTrue();
    run(200);
    assertThat(member.isRefused()).as("the other answers each time").isTrue();
    assertThat(other.asked).hasSizeBetween(3, 4);
    assertThat(statuses).last().matches(status -> status.boot().equals(EARLIER));
    other.gone = true;
    run(300);
    assertThat(member.isRefused()).isFalse();
    assertThatTheLastWordIsItsOwn();
    assertThat(results)
        .as("what ended while it was away")
        .filteredOn(result -> result.id().equals("c1"))
        .extracting(Result::outcome)
        .containsExactly(Outcome.SUCCEEDED);
    send(with(call("c2", "echo", Map.of()), member.boot()));
    run(1);
    assertThat(results).last().matches(result -> result.id().equals("c2"));
  }

  @Test
  void theSecondTakesThePlaceOfTheFirstThatIsGone() {
    for (String client : List.of("rose", "another")) {
      RatsMember first = member;
      member = RatsMember.start(profile(), List::of, bus.client(client), "test", clock);
      run(10);
      assertThat(member.isRefused()).as(client).isTrue();
      first.close();
      run(100);
      assertThat(member.isRefused()).as(client).isFalse();
      assertThatTheLastWordIsItsOwn();
      send(call("to-" + client, "echo", Map.of()));
      run(1);
      assertThat(results).last().matches(result -> result.id().equals("to-" + client));
    }
  }

  @Test
  void whoLeavesForGoodWhileAwayClearsNothingOfTheOther() {
    RatsMember second = RatsMember.start(profile(), List::of, bus.client("other"), "test", clock);
    run(10);
    assertThat(second.isRefused()).isTrue();
    retained.clear();
    second.close();
    run(100);
    assertThat(retained).isEmpty();
  }

  /** Over the same connection as the calls that a member makes itself. */
  @Test
  void whoCallsOthersAsksToo() {
    member.close();
    run(1);
    MemberCalls calls = new MemberCalls("rose", "test", bus.client("rose"), clock);
    member = RatsMember.start(profile(), List::of, calls.transport(), "test", clock);
    run(1);
    new OtherLife();
    say(MemberStatus.Phase.READY);
    run(1);
    assertThat(member.isRefused()).isTrue();
  }

  private void assertThatTheLastWordIsItsOwn() {
    assertThat(statuses)
        .last()
        .isEqualTo(new MemberStatus("rose", MemberStatus.Phase.READY, member.boot()));
  }

  private void say(MemberStatus.Phase phase) {
    publish(
        Publication.retained(
            topics.status("rose"), wire.encode(new MemberStatus("rose", phase, EARLIER))));
  }

  private Transport client(String id) {
    Transport client = bus.client(id);
    client.open(Optional.empty(), new Unconcerned());
    return client;
  }

  /** One that answers pings for the earlier life, and claims to be there when it is doubted. */
  private final class OtherLife {
    private final List<Call> asked = new ArrayList<>();
    private boolean gone;

    private OtherLife() {
      Transport transport = client("other-life");
      transport.subscribe(
          topics.calls(),
          RetainedMessages.IGNORE,
          message -> {
            Call call = wire.decodeCall(message.payload());
            boolean ping = call.feature().equals(ReservedFeature.PING.word());
            if (!gone && ping && call.boot().filter(EARLIER::equals).isPresent()) {
              asked.add(call);
              transport.publish(
                  Publication.reliable(
                      topics.result(call.from(), "rose"),
                      wire.encode(succeeded(call.id(), Map.of())),
                      Optional.empty()),
                  failure -> assertThat(failure).isEmpty());
            }
          });
      run(1);
    }
  }
}
