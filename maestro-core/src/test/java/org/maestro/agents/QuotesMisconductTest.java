package org.maestro.agents;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.agents.runtime.ProtocolTimeouts;

/**
 * The ways in which an agent can misbehave when it is asked for exact prices. Silence is no
 * refusal: who did not answer is asked again before a goal is given up, and for later goals.
 */
class QuotesMisconductTest {
  private static final String GOAL = "(guided Bob)";
  private static final Duration QUOTE = ProtocolTimeouts.standard().quote();
  private static final Duration WORK = Duration.ofSeconds(3);

  @RegisterExtension static final SocietyExtension STAGE = new SocietyExtension("quotes");

  private Society society;

  @BeforeEach
  void gather() {
    society = STAGE.society();
  }

  static Stream<Arguments> misconduct() {
    return Stream.of(
        Arguments.of(
            "silent",
            Actor.Part.onQuestion((actor, question) -> {}),
            "usher (did not say within 7 s what guide would cost)",
            QUOTE),
        Arguments.of(
            "declines",
            Actor.Part.onQuestion(
                (actor, question) ->
                    actor.answer(question, ACLMessage.INFORM, "(cost (:reason \"too far\"))")),
            "usher (guide: too far)",
            Duration.ZERO),
        Arguments.of(
            "refuses",
            Actor.Part.onQuestion(
                (actor, question) ->
                    actor.answer(question, ACLMessage.REFUSE, "(inform (:reason \"a secret\"))")),
            "usher (guide: a secret)",
            Duration.ZERO),
        Arguments.of(
            "too many answers",
            Actor.Part.onQuestion(
                (actor, question) ->
                    actor.answer(
                        question, ACLMessage.INFORM, "(cost (:price 1 1)) (cost (:price 2 2))")),
            "usher (named 2 prices for guide where 1 were asked)",
            Duration.ZERO),
        Arguments.of(
            "no answer in the answer",
            Actor.Part.onQuestion(
                (actor, question) -> actor.answer(question, ACLMessage.INFORM, null)),
            "usher (said unreadably what guide would cost",
            Duration.ZERO),
        Arguments.of(
            "negative",
            Actor.Part.onQuestion(
                (actor, question) ->
                    actor.answer(question, ACLMessage.INFORM, "(cost (:price -4 1))")),
            "usher (guide: asks -4 and 1 s for guide, which is no price)",
            Duration.ZERO),
        Arguments.of(
            "absurd",
            Actor.Part.onQuestion(
                (actor, question) ->
                    actor.answer(question, ACLMessage.INFORM, "(cost (:price 1e300 1))")),
            "for guide, which is no price",
            Duration.ZERO),
        Arguments.of(
            "no number",
            Actor.Part.onQuestion(
                (actor, question) ->
                    actor.answer(question, ACLMessage.INFORM, "(cost (:price much 1))")),
            "usher (guide: asks much and 1 s for guide, which is no price)",
            Duration.ZERO));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("misconduct")
  void anotherDoesIt(String way, Actor.Part part, String told, Duration lost) {
    society.add("usher", part);
    Actor butler = society.add("butler", Actor.Part.at(3));

    society.assertDoneBy(butler, society.pursue(GOAL), told, lost.plus(WORK));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("misconduct")
  void aloneTheGoalFailsForThatReason(String way, Actor.Part part, String told, Duration lost) {
    society.add("usher", part);

    society.assertGivenUp(
        society.pursue(GOAL),
        told,
        lost.multipliedBy(5).plus(Society.BEFORE_THE_LAST_TRY).plus(WORK));
  }

  @Test
  void whoWasSilentOnceIsAskedAgain() {
    AtomicInteger questions = new AtomicInteger();
    Actor usher =
        society.add(
            "usher",
            Actor.Part.onQuestion(
                (actor, question) -> {
                  if (questions.incrementAndGet() > 1) {
                    actor.answer(question, ACLMessage.INFORM, "(cost (:price 1 1))");
                  }
                }));

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(usher.heard())
        .containsExactly("cfp", "request", "request", "accept-proposal", "request");
    assertThat(outcome.took()).isLessThan(QUOTE.plus(WORK));
    assertThat(society.leftover()).isEmpty();
  }

  @Test
  void anAgentKilledBeforeItNamesItsPriceIsReplaced() {
    society.add(
        "usher",
        new Actor.Part() {
          @Override
          public void called(Actor actor, ACLMessage cfp) {
            Actor.Part.super.called(actor, cfp);
            actor.clock().schedule(Duration.ofMillis(2), "test", () -> society.kill("usher"));
          }
        });
    society.add("butler", Actor.Part.at(3));

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(society.told()).contains("usher (has no agent any more");
    assertThat(society.leftover()).isEmpty();
  }
}
