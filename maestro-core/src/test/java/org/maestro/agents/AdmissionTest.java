package org.maestro.agents;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.platform.Hearing;

/**
 * Messages that nobody should send: each gets one clear answer, none stays in the queue, and the
 * CCA takes goals as before.
 */
class AdmissionTest {
  private static final String GOAL = "(initCNP (:goal (greeted Bob)))";

  @RegisterExtension static final SocietyExtension STAGE = new SocietyExtension("admission");

  private Society society;
  private Guest guest;

  @BeforeEach
  void gather() {
    society = STAGE.society();
    guest = new Guest(society.birth(), society.time);
    society.start("guest", guest);
  }

  static Stream<Arguments> malformed() {
    return Stream.of(
        message("another language", m -> m.setLanguage("fipa-sl0"), "fipa-sl0"),
        message("another ontology", m -> m.setOntology("Bookshop"), "Bookshop"),
        message("another encoding", m -> m.setEncoding("base64"), "base64"),
        message("no content", m -> m.setContent(null), "no content"),
        message("empty content", m -> m.setContent("   "), "no content"),
        message("bytes", m -> m.setByteSequenceContent(new byte[] {1, 2, 3}), "bytes"),
        message(
            "a megabyte",
            m -> m.setContent("(initCNP (:goal (greeted " + "B".repeat(1_000_000) + ")))"),
            "more than 262144 are not read"),
        message("deep", m -> m.setContent("(".repeat(10_000)), "nesting"),
        message("not a sentence", m -> m.setContent("how are you?"), "column"),
        message("unknown operator", m -> m.setContent("(dance)"), "dance"),
        message("a proposal", m -> m.setPerformative(ACLMessage.PROPOSE), "propose"),
        message("an unknown performative", m -> m.setPerformative(ACLMessage.PROXY), "proxy"),
        message(
            "news of nobody",
            m -> {
              m.setPerformative(ACLMessage.INFORM);
              m.setContent("(inform (:outputs))");
            },
            "informed of members"),
        message(
            "a call for proposals",
            m -> {
              m.setPerformative(ACLMessage.CFP);
              m.setProtocol("fipa-contract-net");
            },
            "cfp"));
  }

  private static Arguments message(String kind, Consumer<ACLMessage> change, String answer) {
    return Arguments.of(kind, change, answer);
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("malformed")
  void isNotUnderstoodOnce(String kind, Consumer<ACLMessage> change, String answer) {
    ACLMessage message = request();
    message.setConversationId("talk");
    change.accept(message);

    guest.say(message);
    guest.say((ACLMessage) message.clone());
    society.pass(Duration.ofSeconds(1));

    assertThat(guest.heard).hasSize(1);
    assertThat(guest.heard.get(0).getPerformative()).isEqualTo(ACLMessage.NOT_UNDERSTOOD);
    assertThat(guest.heard.get(0).getContent().toLowerCase()).contains(answer.toLowerCase());
    assertThat(guest.heard.get(0).getContent()).hasSizeLessThan(600);
    assertUnharmed();
  }

  @Test
  void notUnderstoodIsNeverAnswered() {
    ACLMessage message = request();
    message.setPerformative(ACLMessage.NOT_UNDERSTOOD);
    guest.say(message);
    message.setConversationId("talk");
    guest.say(message);
    society.pass(Duration.ofSeconds(1));

    assertThat(guest.heard).isEmpty();
    assertUnharmed();
  }

  /** An agent that protests at whatever it hears, as the CCA does. */
  @Test
  void twoThatDoNotUnderstandEachOtherFallSilent() {
    guest.answerAllWith(ACLMessage.REQUEST, "(dance)");

    guest.say(dance());
    society.pass(Duration.ofMinutes(1));

    assertThat(guest.heard).hasSize(1);
    assertUnharmed();
  }

  @Test
  void lateContractNetMessagesAreDropped() {
    for (int performative :
        new int[] {ACLMessage.PROPOSE, ACLMessage.INFORM, ACLMessage.ACCEPT_PROPOSAL}) {
      ACLMessage message = request();
      message.setPerformative(performative);
      message.setProtocol("fipa-contract-net");
      message.setConversationId("long over");
      guest.say(message);
    }
    society.pass(Duration.ofSeconds(1));

    assertThat(guest.heard).isEmpty();
    assertUnharmed();
  }

  @Test
  void aMessageWithoutASenderIsDropped() {
    society.cca.postMessage(withSender(null));
    society.cca.postMessage(withSender(new AID()));
    society.pass(Duration.ofSeconds(1));

    assertUnharmed();
  }

  @Test
  void othersMessagesAreCheckedToo() {
    ACLMessage message = dance();
    message.clearAllReceiver();
    message.addReceiver(society.desk.getAID());
    guest.say(message);
    society.pass(Duration.ofSeconds(1));

    assertThat(guest.heard).hasSize(1);
    assertUnharmed();
  }

  private static ACLMessage withSender(AID sender) {
    ACLMessage message = request();
    message.setSender(sender);
    return message;
  }

  private void assertUnharmed() {
    society.add("butler", new Actor.Part() {});
    assertThat(society.pursue("(greeted Bob)").reached()).as(society.told()).isTrue();
    // What is put into an agent's queue past JADE's mail, the stepped clock does not wait for.
    Awaitility.await()
        .pollDelay(Duration.ZERO)
        .untilAsserted(() -> assertThat(society.leftover()).isEmpty());
  }

  private static ACLMessage dance() {
    ACLMessage message = request();
    message.setContent("(dance)");
    return message;
  }

  private static ACLMessage request() {
    ACLMessage message = new ACLMessage(ACLMessage.REQUEST);
    message.setLanguage("MAESTRO-SL");
    message.setOntology("WorldModel");
    message.setContent(GOAL);
    return message;
  }

  /** Says what it is told to, and keeps what it hears. */
  private static final class Guest extends MaestroAgent {
    private static final long serialVersionUID = 1L;
    private final transient List<ACLMessage> heard =
        Collections.synchronizedList(new ArrayList<>());
    private transient Consumer<ACLMessage> answer = message -> {};

    Guest(Birth birth, AgentTime time) {
      super(birth, time);
    }

    @Override
    protected void setup() {
      super.setup();
      addBehaviour(new Hearing(this, this::heard));
    }

    private void heard(ACLMessage message) {
      heard.add(message);
      answer.accept(message);
    }

    void say(ACLMessage message) {
      ACLMessage said = (ACLMessage) message.clone();
      if (!said.getAllReceiver().hasNext()) {
        said.addReceiver(getAID(AgentNames.COORDINATOR));
      }
      tell(() -> send(said));
    }

    void answerAllWith(int performative, String content) {
      answer =
          message -> {
            ACLMessage reply = message.createReply();
            reply.setPerformative(performative);
            reply.setContent(content);
            send(reply);
          };
    }

    @Override
    protected boolean expects(ACLMessage message) {
      return true;
    }

    @Override
    protected void received(ACLMessage message) {
      throw new IllegalStateException("Nothing is left for here: " + message);
    }
  }
}
