package org.maestro.rats.protocol;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.rats.protocol.MemberState.Ended;

/** What makes a call the same call as before, and a state the same news. */
class SameAgainTest {

  private static final Call.Sent THEN = new Call.Sent("k1", 7);
  private static final Call CALL = call("c1", "rose", "pick", 1, 5, "cca", "G1").madeAt(THEN);
  private static final MemberState STATE = state("on", "(on)", "c1", "c2", "pick");

  @Test
  void aCallKeepsAllButItsTime() {
    Call later = CALL.madeAt(new Call.Sent("k2", 9));
    assertThat(later.sent()).contains(new Call.Sent("k2", 9));
    assertThat(later.madeAt(THEN)).isEqualTo(CALL);
    assertThat(later.expects()).isEqualTo(CALL.expects()).isPresent();
  }

  @Test
  void aCallIsTheSameWhateverItsCallerCountsOnByThen() {
    Call plain = call("c1", "rose", "pick", 1, 5, "cca", "G1");
    Call bare =
        new Call(
            plain.id(),
            plain.member(),
            plain.boot(),
            plain.feature(),
            plain.parameters(),
            plain.timeout(),
            plain.from(),
            plain.task());
    assertThat(bare.isAgain(CALL)).isTrue();
    assertThat(CALL.isAgain(bare)).isTrue();
    assertThat(CALL.isAgain(CALL.madeAt(new Call.Sent("k2", 0)))).isTrue();
  }

  static Stream<Call> others() {
    return Stream.of(
        call("c2", "rose", "pick", 1, 5, "cca", "G1"),
        call("c1", "tulip", "pick", 1, 5, "cca", "G1"),
        call("c1", "rose", "place", 1, 5, "cca", "G1"),
        call("c1", "rose", "pick", 2, 5, "cca", "G1"),
        call("c1", "rose", "pick", 1, 6, "cca", "G1"),
        call("c1", "rose", "pick", 1, 5, "tim", "G1"),
        call("c1", "rose", "pick", 1, 5, "cca", "G2"),
        anyones(CALL));
  }

  @ParameterizedTest
  @MethodSource("others")
  void anotherCallIsNotTheSame(Call other) {
    assertThat(CALL.isAgain(other)).isFalse();
    assertThat(other.isAgain(CALL)).isFalse();
  }

  @Test
  void aCallComesBackWithWhatItsCallerCountsOn() throws IOException {
    WireFormat wire = new WireFormat();
    new Schemas().assertValid("call", wire.encode(CALL));
    assertThat(wire.decodeCall(wire.encode(CALL))).isEqualTo(CALL);
  }

  @Test
  void aStateIsNoNewsThoughCallsEnded() {
    MemberState ended = withRecent(STATE, new Ended("c0", Outcome.FAILED));
    assertThat(STATE.saysTheSameAs(ended)).isTrue();
    assertThat(ended.saysTheSameAs(STATE)).isTrue();
    assertThat(ended.saysTheSameAs(withRecent(STATE, new Ended("c9", Outcome.CANCELED)))).isTrue();
  }

  static Stream<MemberState> news() {
    return Stream.of(
        state("off", "(on)", "c1", "c2", "pick"),
        state("on", "(off)", "c1", "c2", "pick"),
        state("on", "(on)", "c3", "c2", "pick"),
        state("on", "(on)", "c1", "c3", "pick"),
        state("on", "(on)", "c1", "c2", "place"));
  }

  @ParameterizedTest
  @MethodSource("news")
  void aStateThatDiffersIsNews(MemberState other) {
    assertThat(STATE.saysTheSameAs(other)).isFalse();
  }

  @Test
  void aStateKeepsAllButItsValues() {
    MemberState ended = withRecent(STATE, new Ended("c0", Outcome.FAILED));
    MemberState changed = ended.with(List.of("(off)"));
    assertThat(changed.values()).containsExactly("(off)");
    assertThat(changed.with(List.of("(on)"))).isEqualTo(ended);
  }

  private static Call call(
      String id, String member, String feature, int level, int seconds, String from, String task) {
    return new Call(
        id,
        Optional.of(member),
        Optional.of("b1"),
        feature,
        Map.of("level", level),
        Duration.ofSeconds(seconds),
        from,
        Optional.of(task),
        Optional.of(new Call.Expectation(4.5, 3.25)));
  }

  private static Call anyones(Call call) {
    return new Call(
        call.id(),
        call.member(),
        Optional.empty(),
        call.feature(),
        call.parameters(),
        call.timeout(),
        call.from(),
        call.task());
  }

  private static MemberState state(
      String state, String value, String running, String queued, String disabled) {
    return new MemberState(
        "rose", "b1", state, List.of(value), List.of(running), List.of(queued), List.of(disabled));
  }

  private static MemberState withRecent(MemberState state, Ended ended) {
    return new MemberState(
        state.member(),
        state.boot(),
        state.state(),
        state.values(),
        state.running(),
        state.queue(),
        state.disabled(),
        List.of(ended));
  }
}
