package org.maestro.agents;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.agents.runtime.ProtocolTimeouts;

/**
 * The ways in which an agent can misbehave when it is ordered to do a step (FIPA request). An order
 * fails twice at most before its agent is left alone; then the butler does it, or the goal fails.
 */
class OrdersMisconductTest {
  private static final String GOAL = "(greeted Bob)";
  private static final ProtocolTimeouts PATIENCE = ProtocolTimeouts.standard();
  private static final int TRIES = 2;

  /** Thrice the second that greeting takes, the bus's time, and the grace for reporting. */
  private static final Duration STEP =
      Duration.ofSeconds(3).plusSeconds(15).plus(PATIENCE.report());

  private static final Duration WORK = Duration.ofSeconds(4);

  @RegisterExtension static final SocietyExtension STAGE = new SocietyExtension("orders");

  private Society society;

  @BeforeEach
  void gather() {
    society = STAGE.society();
  }

  static Stream<Arguments> misconduct() {
    return Stream.of(
        Arguments.of(
            "silent",
            Actor.Part.onOrder((actor, order) -> {}),
            "usher did not take up greet within 10 s",
            PATIENCE.agreement()),
        Arguments.of(
            "agrees and never reports",
            Actor.Part.onOrder(
                (actor, order) -> actor.answer(order, ACLMessage.AGREE, "(perform)")),
            "usher agreed to greet and did not report within 28 s",
            STEP),
        Arguments.of(
            "refuses",
            Actor.Part.onOrder(
                (actor, order) ->
                    actor.answer(order, ACLMessage.REFUSE, "(inform (:reason \"my break\"))")),
            "usher says: my break",
            Duration.ZERO),
        Arguments.of(
            "does not understand",
            Actor.Part.onOrder(
                (actor, order) -> actor.answer(order, ACLMessage.NOT_UNDERSTOOD, "(hm)")),
            "usher answered the order of greet with not-understood",
            Duration.ZERO),
        Arguments.of(
            "reports unreadably",
            Actor.Part.onOrder(
                (actor, order) -> {
                  actor.answer(order, ACLMessage.AGREE, "(perform)");
                  actor.answer(order, ACLMessage.INFORM, ")(");
                }),
            "usher reported greet unreadably",
            Duration.ZERO),
        Arguments.of(
            "reports nothing at all",
            Actor.Part.onOrder((actor, order) -> actor.answer(order, ACLMessage.INFORM, null)),
            "usher reported greet unreadably",
            Duration.ZERO),
        Arguments.of(
            "fails without a word",
            Actor.Part.onOrder((actor, order) -> actor.answer(order, ACLMessage.FAILURE, null)),
            "usher answered the order of greet with failure",
            Duration.ZERO),
        Arguments.of(
            "proposes",
            Actor.Part.onOrder(
                (actor, order) -> actor.answer(order, ACLMessage.PROPOSE, "(inform)")),
            "usher answered the order of greet with propose",
            Duration.ZERO));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("misconduct")
  void anotherDoesIt(String way, Actor.Part part, String told, Duration lostEachTime) {
    society.add("usher", part);
    Actor butler = society.add("butler", Actor.Part.at(3));

    society.assertDoneBy(
        butler, society.pursue(GOAL), told, lostEachTime.multipliedBy(TRIES).plus(WORK));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("misconduct")
  void aloneTheGoalFails(String way, Actor.Part part, String told, Duration lostEachTime) {
    society.add("usher", part);

    society.assertGivenUp(
        society.pursue(GOAL),
        told,
        lostEachTime.multipliedBy(TRIES + 1).plus(Society.BEFORE_THE_LAST_TRY).plus(WORK));
  }

  @Test
  void whoNeverReportsIsCalledOff() {
    Actor usher =
        society.add(
            "usher",
            Actor.Part.onOrder(
                (actor, order) -> actor.answer(order, ACLMessage.AGREE, "(perform)")));

    society.pursue(GOAL);

    assertThat(usher.heard())
        .containsSubsequence("accept-proposal", "request", "cancel", "request", "cancel");
  }

  @Test
  void aReportBeforeAgreementCountsAndIsTold() {
    society.add(
        "usher",
        Actor.Part.onOrder(
            (actor, order) -> {
              actor.done(order);
              actor.answer(order, ACLMessage.AGREE, "(perform)");
            }));
    Actor butler = society.add("butler", Actor.Part.at(3));

    assertThat(society.pursue(GOAL).reached()).as(society.told()).isTrue();

    assertThat(butler.heard()).doesNotContain("request");
    assertThat(society.told()).contains("usher reported greet before it agreed to it");
    assertThat(society.leftover()).isEmpty();
  }

  @Test
  void theSecondReportIsIgnored() {
    society.add(
        "usher",
        Actor.Part.onOrder(
            (actor, order) -> {
              actor.answer(order, ACLMessage.AGREE, "(perform)");
              actor.answer(order, ACLMessage.FAILURE, "(inform (:problem \"hoarse\"))");
              actor.done(order);
            }));
    Actor butler = society.add("butler", Actor.Part.at(3));

    assertThat(society.pursue(GOAL).reached()).as(society.told()).isTrue();

    assertThat(butler.heard()).endsWith("request");
    assertThat(society.told()).contains("usher sent inform for greet after that was over");
    assertThat(society.leftover()).isEmpty();
  }

  @Test
  void anAgentKilledAtItsWorkIsReplacedAtOnce() {
    society.add(
        "usher",
        Actor.Part.onOrder(
            (actor, order) -> {
              actor.answer(order, ACLMessage.AGREE, "(perform)");
              actor.clock().schedule(Duration.ofMillis(50), "test", () -> killed("usher"));
            }));
    Actor butler = society.add("butler", Actor.Part.at(3));

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(butler.heard()).endsWith("request");
    assertThat(society.told()).contains("usher has lost its agent while it was at greet");
    assertThat(outcome.took()).isLessThan(WORK);
    assertThat(society.leftover()).isEmpty();
  }

  /** Its container died, and another agent takes over: the same words, and one report. */
  @Test
  void anAgentThatTakesOverIsAskedForTheSameInTheSameWords() {
    List<String> orders = new ArrayList<>();
    society.add(
        "usher",
        Actor.Part.onOrder(
            (actor, order) -> {
              orders.add(order.getContent());
              actor.answer(order, ACLMessage.AGREE, "(perform)");
              actor.clock().schedule(Duration.ofMillis(50), "test", () -> movesTo(orders));
            }));

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(orders).hasSize(2).allMatch(orders.get(0)::equals);
    assertThat(society.told()).doesNotContain("lost its agent").doesNotContain("REPLAN");
    assertThat(society.leftover()).isEmpty();
  }

  /** Nobody takes over: the order is lost with its agent, and somebody else does it. */
  @Test
  void whenNobodyTakesOverAnotherIsOrdered() {
    society.add(
        "usher",
        Actor.Part.onOrder(
            (actor, order) -> {
              actor.answer(order, ACLMessage.AGREE, "(perform)");
              actor
                  .clock()
                  .schedule(
                      Duration.ofMillis(50),
                      "test",
                      () -> {
                        society.cca.agentMoves("usher");
                        society.kill("usher");
                        society.cca.agentStaysAway("usher", "no host fits");
                      });
            }));
    Actor butler = society.add("butler", Actor.Part.at(3));

    Society.Outcome outcome = society.pursue(GOAL);

    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(butler.heard()).endsWith("request");
    assertThat(society.leftover()).isEmpty();
  }

  private void movesTo(List<String> orders) {
    society.cca.agentMoves("usher");
    society.kill("usher");
    society.start(
        "usher",
        new Actor(
            society.birth(),
            society.time,
            Actor.Part.onOrder(
                (actor, order) -> {
                  orders.add(order.getContent());
                  actor.answer(order, ACLMessage.AGREE, "(perform)");
                  actor.later(Duration.ofSeconds(1), () -> actor.done(order));
                })));
  }

  /** As the platform does when JADE tells it that an agent has ended. */
  private void killed(String agent) {
    society.kill(agent);
    society.cca.agentEnded(agent);
  }
}
