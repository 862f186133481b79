package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.MethodOrderer;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestMethodOrder;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Orders;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.references.Wanted;
import org.maestro.coordination.api.Argument;
import org.maestro.junit.Stage;
import org.maestro.platform.jade.SentMessage;
import org.maestro.sl.Term;

/**
 * Who wants to refer to an agent asks the supervisor, which passes that on or says why not (ADE,
 * 3.1; A25, A27): the messages, in their order. The home lets the desk ask for lamps.
 */
@TestMethodOrder(MethodOrderer.OrderAnnotation.class)
class ReferralTest {
  private static final String DESK_ASKS_LAMPS =
      """

      home:deskDims a maestro:Permission ; maestro:caller "desk" ; maestro:asks :Lamp .
      """;

  private static final int MOST_SEARCHES = 100;

  private static final List<SentMessage> MAIL = new CopyOnWriteArrayList<>();
  private static Stage stage;

  @BeforeAll
  static void begin() {
    stage = Stage.stepped(OwnAccordTest.site("referral", DESK_ASKS_LAMPS, "", ""));
    stage.run(Duration.ofSeconds(5));
    stage
        .platform()
        .onMail(
            message -> {
              if (message.protocol().filter("fipa-recruiting"::equals).isPresent()) {
                MAIL.add(message);
              }
            });
  }

  @AfterAll
  static void end() {
    stage.close();
  }

  @BeforeEach
  void nothingWasSaid() {
    MAIL.clear();
  }

  private static AskedReference ask(Wanted wanted) {
    AskedReference asked = AskedReference.by(desk(), wanted);
    stage.await("it is answered", asked::isAnswered);
    return asked;
  }

  private static DeskAgent desk() {
    return stage.platform().desk();
  }

  /** The conversation in which something was asked for first. */
  private static Optional<String> asked() {
    return MAIL.stream()
        .filter(message -> message.performative().equals("proxy"))
        .findFirst()
        .flatMap(SentMessage::conversation);
  }

  private static List<String> sequence(Optional<String> conversation) {
    return MAIL.stream()
        .filter(message -> message.conversation().equals(conversation))
        .map(
            message ->
                "%s %s %s"
                    .formatted(
                        message.performative(), name(message.sender()), name(message.receiver())))
        .toList();
  }

  private static String name(String agent) {
    return agent.substring(0, agent.indexOf('@'));
  }

  @Test
  void theRequestOfWhoMayIsPassedOnAndAnsweredByTheOneAskedForItself() {
    AskedReference asked = ask(Wanted.agent("lamp-a1"));

    assertThat(asked.reasons()).isEmpty();
    assertThat(sequence(asked()))
        .as("one diagram shows all of it")
        .startsWith(
            "proxy desk supervisor",
            "agree supervisor desk",
            "request supervisor lamp-a1",
            "inform lamp-a1 desk");
  }

  @Test
  void whoWantsAFeatureIsReferredToOneOfWhomHeMayAskIt() {
    AskedReference asked = ask(Wanted.feature("adjustLight"));
    // The yellow pages take their time: they know nothing of a stepped clock.
    for (int i = 0; i < MOST_SEARCHES && asked.reference().isEmpty(); i++) {
      asked = ask(Wanted.feature("adjustLight"));
    }

    assertThat(asked.reference()).as(asked.reasons().toString()).isPresent();
    assertThat(asked.reference().orElseThrow().agent().getLocalName()).startsWith("lamp-");
    assertThat(ask(Wanted.feature("juggle")).reasons())
        .containsExactly("supervisor says: Nobody offers juggle now.");
  }

  @Test
  void whoMayNotIsToldWhyAndTheOneAskedForHearsNothing() {
    AskedReference asked = ask(Wanted.agent("rose"));

    assertThat(asked.reference()).isEmpty();
    assertThat(asked.reasons())
        .containsExactly(
            "supervisor says: no maestro:Permission of the home lets desk ask rose for anything");
    assertThat(sequence(asked()))
        .containsExactly("proxy desk supervisor", "refuse supervisor desk");
    assertThat(MAIL).noneMatch(message -> message.receiver().startsWith("rose@"));
    assertThat(ask(Wanted.agent("ghost")).reasons())
        .containsExactly(
            "supervisor says: There is no agent ghost; ./maestro agents lists those there are.");
  }

  @Test
  @Order(Integer.MAX_VALUE)
  void callsAndSignsOfLifeGoOnWithoutTheRegistry() {
    AskedReference asked = ask(Wanted.agent("lamp-a1"));
    stage.platform().endAgent(AgentNames.SUPERVISOR);
    stage.run(Duration.ofMinutes(1));
    List<ACLMessage> replies = new CopyOnWriteArrayList<>();
    desk()
        .request(
            ACLMessage.REQUEST,
            "lamp-a1",
            Duration.ofSeconds(30),
            replies::add,
            Orders.plain(
                "lamp-a1",
                "lamp-a1",
                "adjustLight",
                Duration.ofSeconds(10),
                Map.of("level", new Argument(new Term.Number(0.5), Optional.empty(), Map.of()))));
    stage.await("the lamp is set", () -> stage.world().lampLevel("lamp-a1") == 0.5);

    assertThat(asked.reasons()).isEmpty();
    assertThat(asked.reference().orElseThrow().condition()).isEqualTo(Condition.ALIVE);
    assertThat(ask(Wanted.agent("lamp-a2")).reasons())
        .as("there is nobody to ask for another one")
        .isNotEmpty();
  }
}
