package org.maestro.rats.faults;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.AutoClose;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.security.LogLines;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;

/**
 * Every call gets an answer, also one that holds what nobody can write: half a character, a number
 * that is none, too much.
 */
@Isolated("other tests write to the log")
class HalfCharacterTest {

  private static final String CALL =
      "{\"v\":\"1.0\",\"id\":\"c1\",\"r\":\"rose\",\"f\":\"deed\",\"p\":{\"a\":\"x\"},"
          + "\"t\":5000,\"from\":\"vandal\",\"task\":\"G1\"}";

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final Topics topics = new Topics("home");
  private final WireFormat wire = new WireFormat();
  private final List<String> facts = new CopyOnWriteArrayList<>();
  @AutoClose private final LogLines log = LogLines.of("org.maestro.rats");
  private Object value = "whole";
  private RatsMember rose;
  private RatsLink link;
  private Vandal vandal;

  @BeforeEach
  void join() {
    Procedure deed =
        new Procedure() {
          @Override
          public void start(Execution execution) {
            execution.succeed(Map.of("value", value));
          }

          @Override
          public CostAnswer cost(Map<String, Object> parameters) {
            return new CostAnswer(Optional.of(1.0), Optional.of(1.0), Optional.empty());
          }
        };
    MemberProfile profile =
        new MemberProfile(
            "rose",
            "{}",
            Set.of("standby"),
            "standby",
            Set.of("standby"),
            Map.of(
                "deed",
                new MemberProfile.Feature(
                    "deed", Set.of(), Set.of(), false, Optional.empty(), "standby", deed)));
    rose = RatsMember.start(profile, () -> facts, bus.client("rose"), "home", clock);
    link = BusLink.connect("cca", "home", bus.client("cca"), clock);
    vandal = Vandal.join(bus, topics, clock);
  }

  @AfterEach
  void leavesNoTraceOfTheCode() {
    assertThat(log.events()).allMatch(event -> event.getThrowableProxy() == null);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "\"x\"|\"\\ud800\"",
        "\"x\"|\"\\udc00 and more\"",
        "\"x\"|[1, {\"b\": \"\\ud83d\"}]",
        "\"a\"|\"\\ud800\"",
        "\"deed\"|\"\\ud800\"",
        "\"G1\"|\"\\ud800\"",
        "\"x\"|\"\u00c3\"",
        "\"deed\"|\"de\u00f0\u009f\u0098\"",
        "\"G1\"|\"\u00ff\u00fe\"",
        "5000|\"SMILES\""
      })
  void aCallWithHalfACharacterIsRefused(String replacement) {
    String[] parts = replacement.split("\\|");
    say(CALL.replace(parts[0], parts[1]).replace("SMILES", smiles()));
    assertThat(vandal.results)
        .singleElement()
        .satisfies(
            result -> {
              assertThat(result.id()).isEqualTo("c1");
              assertThat(result.outcome()).isEqualTo(Outcome.REJECTED);
              assertThat(result.error().map(RatsError::code)).contains(ErrorCode.MALFORMED);
            });
    assertThat(log.lines()).hasSize(1);
  }

  /** In UTF-8 it could not be told which one is meant; the caller hears of it all the same. */
  @Test
  void alsoWhenItsIdHasIt() {
    say(CALL.replace("c1", "c\\ud800"));
    assertThat(vandal.results).singleElement().extracting(Result::id).isEqualTo("c\uFFFD");
  }

  static List<Object> unsendable() {
    return List.of(
        "\ud800",
        Double.NaN,
        List.of(1, Double.POSITIVE_INFINITY),
        new Object(),
        "x".repeat(300_000));
  }

  @ParameterizedTest
  @MethodSource("unsendable")
  void whatCannotBeSentIsToldAsAFailure(Object told) {
    value = told;
    Result result = called();
    assertThat(result.outcome()).isEqualTo(Outcome.FAILED);
    assertThat(result.error().map(RatsError::code)).contains(ErrorCode.INTERNAL);
    value = "whole";
    assertThat(called().outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  @Test
  void anAnswerThatNobodyCanReadEndsTheCall() {
    rose.die();
    clock.run(Duration.ofSeconds(1));
    vandal.hear(topics.calls(), call -> answer(call.payload()));
    vandal.publish(
        Publication.retained(
            topics.status("rose"),
            wire.encode(new MemberStatus("rose", MemberStatus.Phase.READY, "1"))));
    clock.run(Duration.ofSeconds(1));
    Outcomes outcomes = new Outcomes();
    link.call("rose", "deed", Map.of(), Duration.ofDays(1), Optional.empty(), outcomes);
    clock.run(Duration.ofSeconds(1));
    assertThat(outcomes.results.get(0).error().orElseThrow().message())
        .contains("rose", "cannot be read", "z", "half a character");
    assertThat(outcomes.results).hasSize(1);
  }

  @Test
  void factsThatCannotBeSentCostOneLine() {
    facts.add("(name rose \ud800)");
    for (int time = 0; time < 5; time++) {
      clock.schedule(Duration.ZERO, "rose", rose::stateChanged);
      clock.run(Duration.ofSeconds(1));
    }
    assertThat(log.lines())
        .singleElement()
        .asString()
        .contains("rose cannot tell its state", "values", "half a character");
    assertThat(called().outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  private Result called() {
    Outcomes outcomes = new Outcomes();
    link.call("rose", "deed", Map.of(), Duration.ofSeconds(5), Optional.empty(), outcomes);
    clock.run(Duration.ofSeconds(1));
    assertThat(outcomes.results).hasSize(1);
    return outcomes.results.get(0);
  }

  private void answer(byte[] call) {
    String answer =
        "{\"v\":\"1.0\",\"id\":\"%s\",\"from\":\"rose\",\"outcome\":\"SUCCEEDED\",\"z\":\"\\ud800\"}"
            .formatted(wire.decodeCall(call).id());
    vandal.publish(
        Publication.reliable(
            topics.result("cca", "rose"), answer.getBytes(UTF_8), Optional.empty()));
  }

  /** So many that they are cut, in the middle of one. */
  private static String smiles() {
    return "a" + "\ud83d\ude00".repeat(100);
  }

  /** Characters up to 255 stand for the bytes of that value. */
  private void say(String payload) {
    byte[] bytes =
        payload.chars().anyMatch(c -> c > 255)
            ? payload.getBytes(UTF_8)
            : payload.getBytes(ISO_8859_1);
    vandal.say(topics.call("vandal"), bytes);
  }
}
