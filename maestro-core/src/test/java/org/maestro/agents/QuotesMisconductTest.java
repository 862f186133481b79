package org.maestro.agents;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.agents.runtime.ProtocolTimeouts;
import org.maestro.platform.BareJade;

/**
 * The ways in which an agent can misbehave when it is asked for exact prices. Silence is no
 * refusal: who did not answer is asked again before a goal is given up, and for later goals.
 */
class QuotesMisconductTest {
  private static final String GOAL = "(guided Bob)";
  private static final Duration QUOTE = ProtocolTimeouts.standard().quote();
  private static final Duration WORK = Duration.ofSeconds(3);

  @TempDir static Path files;
  private static BareJade jade;

  private Society society;

  @BeforeAll
  static void startJade() {
    jade = new BareJade("quotes", files);
  }

  @AfterAll
  static void endJade() {
    jade.close();
  }

  @BeforeEach
  void gather() {
    society = new Society(jade);
  }

  @AfterEach
  void disperse() {
    society.close();
  }

  static Stream<Arguments> misconduct() {
    return Stream.of(
        Arguments.of(
            "silent",
            onQuestion((actor, question) -> {}),
            "usher (did not say within 7 s what guide would cost)",
            QUOTE),
        Arguments.of(
            "declines",
            onQuestion(
                (actor, question) ->
                    actor.answer(question, ACLMessage.INFORM, "(cost (:reason \"too far\"))")),
            "usher (guide: too far)",
            Duration.ZERO),
        Arguments.of(
            "refuses",
            onQuestion(
                (actor, question) ->
                    actor.answer(question, ACLMessage.REFUSE, "(inform (:reason \"a secret\"))")),
            "usher (guide: a secret)",
            Duration.ZERO),
        Arguments.of(
            "too many answers",
            onQuestion(
                (actor, question) ->
                    actor.answer(
                        question, ACLMessage.INFORM, "(cost (:price 1 1)) (cost (:price 2 2))")),
            "usher (named 2 prices for guide where 1 were asked)",
            Duration.ZERO),
        Arguments.of(
            "no answer in the answer",
            onQuestion((actor, question) -> actor.answer(question, ACLMessage.INFORM, null)),
            "usher (said unreadably what guide would cost",
            Duration.ZERO),
        Arguments.of(
            "negative",
            onQuestion(
                (actor, question) ->
                    actor.answer(question, ACLMessage.INFORM, "(cost (:price -4 1))")),
            "usher (guide: asks -4 1 for guide, which is no price)",
            Duration.ZERO),
        Arguments.of(
            "absurd",
            onQuestion(
                (actor, question) ->
                    actor.answer(question, ACLMessage.INFORM, "(cost (:price 1e300 1))")),
            "for guide, which is no price",
            Duration.ZERO),
        Arguments.of(
            "no number",
            onQuestion(
                (actor, question) ->
                    actor.answer(question, ACLMessage.INFORM, "(cost (:price much 1))")),
            "usher (guide: asks much 1 for guide, which is no price)",
            Duration.ZERO));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("misconduct")
  void anotherDoesIt(String way, Actor.Part part, String told, Duration lost) {
    society.add("usher", part);
    Actor butler = society.add("butler", at(3));

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(butler.heard()).endsWith("request");
    assertThat(society.told()).contains(told);
    assertThat(outcome.took()).as(society.told()).isLessThan(lost.plus(WORK));
    assertThat(society.leftover()).isEmpty();
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("misconduct")
  void aloneTheGoalFailsForThatReason(String way, Actor.Part part, String told, Duration lost) {
    society.add("usher", part);

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isFalse();
    assertThat(society.told()).contains(told);
    assertThat(outcome.reply().getContent()).contains("usher");
    assertThat(outcome.took())
        .as(society.told())
        .isLessThan(lost.multipliedBy(5).plus(Society.BEFORE_THE_LAST_TRY).plus(WORK));
    assertThat(society.leftover()).isEmpty();
  }

  @Test
  void whoWasSilentOnceIsAskedAgain() {
    AtomicInteger questions = new AtomicInteger();
    Actor usher =
        society.add(
            "usher",
            onQuestion(
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
    society.add("butler", at(3));

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(society.told()).contains("usher (has no agent any more");
    assertThat(society.leftover()).isEmpty();
  }

  private static Actor.Part at(double price) {
    return new Actor.Part() {
      @Override
      public double price() {
        return price;
      }
    };
  }

  private static Actor.Part onQuestion(BiConsumer<Actor, ACLMessage> deed) {
    return new Actor.Part() {
      @Override
      public void asked(Actor actor, ACLMessage question) {
        deed.accept(actor, question);
      }
    };
  }
}
