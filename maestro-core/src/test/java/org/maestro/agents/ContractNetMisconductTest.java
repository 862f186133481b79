package org.maestro.agents;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import jade.wrapper.AgentContainer;
import jade.wrapper.StaleProxyException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Date;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.agents.runtime.ProtocolTimeouts;

/**
 * The ways in which an agent can misbehave in a contract net. The usher is the cheaper one and
 * misbehaves; the butler is there beside it or is not. Either the butler does it, or the goal fails
 * for the right reason; the story says what the usher did; the time lost is bounded; nothing is
 * left over.
 */
class ContractNetMisconductTest {
  private static final String GOAL = "(greeted Bob)";
  private static final ProtocolTimeouts PATIENCE = ProtocolTimeouts.standard();

  /** What deciding, messages and the greeting itself take. */
  private static final Duration WORK = Duration.ofSeconds(2);

  private static final Duration AT_ONCE = Duration.ZERO;

  @RegisterExtension static final SocietyExtension STAGE = new SocietyExtension("misconduct");
  private static AgentContainer second;

  private Society society;

  @BeforeAll
  static void join() {
    second = STAGE.jade().join("second");
  }

  @BeforeEach
  void gather() {
    society = STAGE.society();
  }

  static Stream<Arguments> misconduct() {
    return Stream.of(
        misconduct(
            "silent",
            Actor.Part.onCall((actor, cfp) -> {}),
            "usher did not answer the call for prices within 10 s",
            PATIENCE.bid()),
        misconduct(
            "refuses",
            Actor.Part.onCall(answering(ACLMessage.REFUSE, "(inform (:reason \"I am off duty\"))")),
            "usher (I am off duty)",
            AT_ONCE),
        misconduct(
            "refuses without a word",
            Actor.Part.onCall(answering(ACLMessage.REFUSE, null)),
            "usher (refused without a reason)",
            AT_ONCE),
        misconduct(
            "does not understand",
            Actor.Part.onCall(
                answering(ACLMessage.NOT_UNDERSTOOD, "(inform (:reason \"what is that?\"))")),
            "usher did not understand the call for prices: what is that?",
            AT_ONCE),
        misconduct(
            "proposes, then nothing",
            Actor.Part.onAccept((actor, accept) -> {}),
            "usher did not say within 5 s that it holds its part",
            PATIENCE.contract().multipliedBy(2)),
        misconduct(
            "proposes, then fails",
            Actor.Part.onAccept(
                answering(ACLMessage.FAILURE, "(inform (:reason \"lost my voice\"))")),
            "usher does not hold its part: lost my voice",
            AT_ONCE),
        misconduct(
            "proposes, then does not understand",
            Actor.Part.onAccept(
                answering(ACLMessage.NOT_UNDERSTOOD, "(inform (:reason \"pardon?\"))")),
            "usher answered the award with not-understood: pardon?",
            AT_ONCE),
        misconduct(
            "proposes, then answers the award with nonsense",
            Actor.Part.onAccept(answering(ACLMessage.PROPOSE, "(what)")),
            "usher answered the award with propose",
            AT_ONCE),
        misconduct(
            "informs instead of proposing",
            Actor.Part.onCall(answering(ACLMessage.INFORM, "(inform (:outputs))")),
            "usher answered the call for prices with inform",
            AT_ONCE),
        misconduct(
            "requests instead of proposing",
            Actor.Part.onCall(answering(ACLMessage.REQUEST, "(perform)")),
            "usher answered the call for prices with request",
            AT_ONCE),
        misconduct(
            "wrong content",
            Actor.Part.onCall(answering(ACLMessage.PROPOSE, "((((")),
            "usher answered the call for prices unreadably",
            AT_ONCE),
        misconduct(
            "no content",
            Actor.Part.onCall(answering(ACLMessage.PROPOSE, null)),
            "usher answered the call for prices unreadably",
            AT_ONCE),
        misconduct(
            "another feature",
            Actor.Part.onCall(
                answering(ACLMessage.PROPOSE, "(cost (:feature fly) (:stated \"1\"))")),
            "usher priced fly, which was not asked",
            AT_ONCE),
        misconduct(
            "no feature",
            Actor.Part.onCall(answering(ACLMessage.PROPOSE, "(cost (:stated \"1\"))")),
            "usher named a price without a feature",
            AT_ONCE),
        misconduct(
            "a megabyte",
            Actor.Part.onCall(
                (actor, cfp) ->
                    actor.answer(cfp, ACLMessage.PROPOSE, "(x " + "y".repeat(1_000_000) + ")")),
            "usher named a price without a feature",
            AT_ONCE));
  }

  private static Arguments misconduct(
      String way, Actor.Part part, String told, Duration lostAtMost) {
    return Arguments.of(way, part, told, lostAtMost);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("misconduct")
  void anotherDoesIt(String way, Actor.Part part, String told, Duration lostAtMost) {
    society.add("usher", part);
    Actor butler = society.add("butler", Actor.Part.at(3));

    society.assertDoneBy(butler, society.pursue(GOAL), told, lostAtMost.plus(WORK));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("misconduct")
  void aloneTheGoalFailsForThatReason(
      String way, Actor.Part part, String told, Duration lostAtMost) {
    society.add("usher", part);

    society.assertGivenUp(
        society.pursue(GOAL), told, lostAtMost.plus(Society.BEFORE_THE_LAST_TRY).plus(WORK));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"NaN", "Infinity", "-Infinity", "1e300", "-5", "(- 5)", "(/ 1 0)", "much", ""})
  void anAbsurdPriceIsNoPrice(String price) {
    society.add("usher", Actor.Part.onCall((actor, cfp) -> actor.propose(cfp, price)));
    Actor butler = society.add("butler", Actor.Part.at(3));

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(butler.heard()).endsWith("request");
    assertThat(society.told()).contains("usher asks " + price, " for greet, which is no price");
    assertThat(outcome.took()).isLessThan(WORK);
    assertThat(society.leftover()).isEmpty();
  }

  @Test
  void theFirstOfTwoAnswersCounts() {
    Actor usher =
        society.add(
            "usher",
            Actor.Part.onCall(
                (actor, cfp) -> {
                  actor.propose(cfp, "1");
                  actor.propose(cfp, "7");
                }));
    society.add("butler", Actor.Part.at(3));

    assertThat(society.pursue(GOAL).reached()).as(society.told()).isTrue();

    assertThat(usher.heard()).endsWith("request");
    assertThat(society.told()).contains("usher answered once more (propose)");
    assertThat(society.leftover()).isEmpty();
  }

  @Test
  void whoInformsBeforeItIsAcceptedIsOrderedAllTheSame() {
    Actor usher =
        society.add(
            "usher",
            Actor.Part.onCall(
                (actor, cfp) -> {
                  actor.propose(cfp, "1");
                  actor.answer(cfp, ACLMessage.INFORM, "(inform (:outputs))");
                }));
    society.add("butler", Actor.Part.at(3));

    assertThat(society.pursue(GOAL).reached()).as(society.told()).isTrue();

    assertThat(usher.heard()).containsExactly("cfp", "accept-proposal", "request");
    assertThat(society.told()).contains("usher informed before its proposal was accepted");
    assertThat(society.leftover()).isEmpty();
  }

  @Test
  void aLateBidIsIgnored() {
    society.add(
        "usher",
        Actor.Part.onCall(
            (actor, cfp) ->
                actor.later(PATIENCE.bid().plusMillis(5), () -> actor.propose(cfp, "1"))));
    Actor butler = society.add("butler", Actor.Part.at(3));

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(butler.heard()).endsWith("request");
    assertThat(society.told()).contains("usher answered (propose) after the round was closed");
    assertThat(society.leftover()).isEmpty();
  }

  @Test
  void aBidThatComesWhenAllIsOverIsDropped() {
    Actor usher =
        society.add(
            "usher",
            Actor.Part.onCall(
                (actor, cfp) -> actor.later(Duration.ofMinutes(2), () -> actor.propose(cfp, "1"))));
    society.add("butler", Actor.Part.at(3));

    assertThat(society.pursue(GOAL).reached()).isTrue();
    society.pass(Duration.ofMinutes(3));

    assertThat(usher.heard()).containsExactly("cfp");
    assertThat(society.cca.getCurQueueSize()).isZero();
    assertThat(society.leftover()).isEmpty();
  }

  @Test
  void aStrangerWhoAnswersInAnotherPlaceIsIgnored() {
    List<ACLMessage> calls = Collections.synchronizedList(new ArrayList<>());
    society.add(
        "usher",
        Actor.Part.onCall(
            (actor, cfp) -> {
              calls.add(cfp);
              actor.later(Duration.ofSeconds(1), () -> actor.propose(cfp, "1"));
            }));
    Actor stranger = society.add("stranger", Actor.Part.at(1));
    stranger.later(
        Duration.ofMillis(500),
        () -> calls.forEach(cfp -> stranger.answer(cfp, ACLMessage.REFUSE, "(inform)")));

    assertThat(society.pursue(GOAL).reached()).as(society.told()).isTrue();

    assertThat(society.told()).contains("stranger answered (refuse) though it was not asked");
    assertThat(society.leftover()).isEmpty();
  }

  @Test
  void anAgentKilledBetweenProposalAndAwardIsReplaced() {
    society.add(
        "usher",
        Actor.Part.onCall(
            (actor, cfp) -> proposeAndLeave(actor, cfp, () -> society.kill("usher"))));
    assertReplacedByTheButler();
  }

  @Test
  void anAgentWhoseContainerIsKilledBetweenProposalAndAwardIsReplaced() {
    society.add(
        second,
        "usher",
        Actor.Part.onCall(
            (actor, cfp) -> proposeAndLeave(actor, cfp, ContractNetMisconductTest::killSecond)));
    assertReplacedByTheButler();
    society.forget("usher");
  }

  /** What it was asked ends with it, and nobody says so but who knows that it has ended. */
  @Test
  void anAgentThatEndsBeforeItAnswersIsNotWaitedFor() {
    society.add(
        "usher",
        Actor.Part.onCall(
            (actor, cfp) ->
                actor
                    .clock()
                    .schedule(
                        Duration.ofSeconds(1),
                        "test",
                        () -> {
                          society.kill("usher");
                          society.cca.agentEnded("usher");
                        })));
    Actor butler = society.add("butler", Actor.Part.at(3));

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(butler.heard()).endsWith("request");
    assertThat(society.told()).contains("usher has no agent any more");
    assertThat(outcome.took()).isLessThan(PATIENCE.bid());
    assertThat(society.leftover()).isEmpty();
  }

  private static void proposeAndLeave(Actor actor, ACLMessage cfp, Runnable leave) {
    actor.propose(cfp, "1");
    actor.clock().schedule(Duration.ofMillis(2), "test", leave);
  }

  private static void killSecond() {
    try {
      second.kill();
    } catch (StaleProxyException e) {
      throw new IllegalStateException(e);
    }
  }

  private void assertReplacedByTheButler() {
    Actor butler = society.add("butler", Actor.Part.at(3));

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(butler.heard()).endsWith("request");
    assertThat(society.told()).contains("usher has no agent any more");
    assertThat(outcome.took()).isLessThan(WORK);
    assertThat(society.leftover()).isEmpty();
  }

  @Test
  void whatJadesToolsShowIsAContractNet() {
    List<ACLMessage> seen = Collections.synchronizedList(new ArrayList<>());
    Actor usher =
        society.add(
            "usher",
            new Actor.Part() {
              @Override
              public void called(Actor actor, ACLMessage cfp) {
                seen.add(cfp);
                Actor.Part.super.called(actor, cfp);
              }

              @Override
              public void accepted(Actor actor, ACLMessage accept) {
                seen.add(accept);
                Actor.Part.super.accepted(actor, accept);
              }
            });
    Actor butler = society.add("butler", Actor.Part.at(3));

    assertThat(society.pursue(GOAL).reached()).isTrue();

    assertThat(usher.heard()).containsExactly("cfp", "accept-proposal", "request");
    assertThat(butler.heard()).containsExactly("cfp", "reject-proposal");
    Date start = Date.from(society.clock.start());
    assertThat(seen)
        .allSatisfy(
            message -> {
              assertThat(message.getProtocol()).isEqualTo("fipa-contract-net");
              assertThat(message.getLanguage()).isEqualTo("MAESTRO-SL");
              assertThat(message.getConversationId())
                  .isEqualTo(seen.get(0).getConversationId())
                  .isNotBlank();
              assertThat(message.getReplyWith()).isNotBlank();
              assertThat(message.getReplyByDate()).isAfter(start).isBefore("2026-01-02");
            });
  }

  @Test
  void theRoundClosesAsSoonAsAllHaveAnswered() {
    society.add("usher", Actor.Part.at(1));
    society.add("butler", Actor.Part.at(3));

    assertThat(society.pursue(GOAL).took()).isLessThan(Duration.ofMillis(1_200));
  }

  private static BiConsumer<Actor, ACLMessage> answering(int performative, String content) {
    return (actor, message) -> actor.answer(message, performative, content);
  }
}
