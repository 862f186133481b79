package org.maestro.platform.guard;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.read.ListAppender;
import jade.core.AID;
import jade.core.Agent;
import jade.core.behaviours.OneShotBehaviour;
import jade.lang.acl.ACLMessage;
import jade.wrapper.AgentContainer;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.Caller;
import org.maestro.platform.BareJade;
import org.maestro.platform.Hearing;
import org.maestro.rats.security.ContainerAccess;
import org.maestro.rats.security.SecureSite;
import org.maestro.rats.security.SiteSecurity;
import org.slf4j.LoggerFactory;

/**
 * Whom agents of a secured site believe. Three containers: the main one, one of another user, and
 * one that came in and signs nothing, in which an insider can write what he likes.
 */
class SignedMailTest {
  @TempDir static Path directory;
  private static final ListAppender<ILoggingEvent> log = new ListAppender<>();
  private static BareJade jade;
  private static ContainerAccess robotsAccess;
  private static Speaker centre;
  private static Speaker rose;
  private static Speaker insider;
  private static Speaker visitor;
  private static Speaker impostor;

  @BeforeAll
  static void start() throws Exception {
    log.start();
    ((Logger) LoggerFactory.getLogger(Refusals.class)).addAppender(log);
    Path files = directory.resolve("site");
    SecureSite.make(
        files,
        "home",
        List.of("localhost"),
        List.of("maestro", "container-robots"),
        List.of(),
        List.of("tablet"));
    SiteSecurity site = SiteSecurity.open(files);
    robotsAccess = site.container("container-robots");
    jade = new BareJade("signing", directory, Optional.of(Guard.open(site, "maestro")));
    centre = speaker(jade.main(), "centre");
    rose = speaker(jade.join("robots", Optional.of(Guard.open(site, "container-robots"))), "rose");
    insider = speaker(jade.join("unsigned"), "insider");
    AgentContainer tablet = jade.join("tablet", Optional.of(Guard.open(site, "tablet")));
    visitor = speaker(tablet, "visitor");
    impostor = speaker(tablet, AgentNames.SUPERVISOR);
  }

  @AfterAll
  static void end() {
    jade.close();
    ((Logger) LoggerFactory.getLogger(Refusals.class)).detachAppender(log);
  }

  private static Speaker speaker(AgentContainer container, String name) throws Exception {
    Speaker speaker = new Speaker();
    container.acceptNewAgent(name, speaker).start();
    assertThat(speaker.ready.await(20, TimeUnit.SECONDS)).isTrue();
    return speaker;
  }

  @Test
  void whatIsSignedArrivesWithTheUserInWhoseProcessItsSenderLives() throws Exception {
    rose.say(message(centre, "((hello))"));
    ACLMessage heard = centre.next();
    assertThat(heard.getContent()).isEqualTo("((hello))");
    assertThat(heard.getUserDefinedParameter(Caller.USER_SLOT)).isEqualTo("container-robots");
    ACLMessage answer = heard.createReply();
    answer.setPerformative(ACLMessage.INFORM);
    centre.say(answer);
    assertThat(rose.next().getUserDefinedParameter(Caller.USER_SLOT)).isEqualTo("maestro");
  }

  @Test
  void aMessageToSeveralIsSignedForEachAndNobodyNamesItsUserHimself() throws Exception {
    ACLMessage message = message(centre, "((all))");
    message.addReceiver(rose.getAID());
    message.addUserDefinedParameter(Caller.USER_SLOT, "somebody greater");
    rose.say(message);
    assertThat(centre.next().getUserDefinedParameter(Caller.USER_SLOT))
        .isEqualTo("container-robots");
    assertThat(rose.next().getUserDefinedParameter(Caller.USER_SLOT)).isEqualTo("container-robots");
  }

  @Test
  void whoWritesAnothersNameIntoTheSenderSlotSendsNothing() throws Exception {
    ACLMessage forged = message(centre, "((perform (:feature unlock)))");
    forged.setSender(new AID("another", AID.ISLOCALNAME));
    rose.say(forged);
    awaitRefusal("The agent rose@signing sent a message in the name of another@");
    assertThat(centre.heard).isEmpty();
  }

  @Test
  void whatIsNotSignedIsRefusedOnceInTheLogAndItsSenderIsToldEachTime() throws Exception {
    for (int time = 0; time < 3; time++) {
      insider.say(message(centre, "((hello))"));
      ACLMessage answer = insider.next();
      assertThat(answer.getPerformative()).isEqualTo(ACLMessage.FAILURE);
      assertThat(answer.getSender().getName()).isEqualTo(insider.getAMS().getName());
    }
    awaitRefusal("in the name of insider@signing was refused: it carries no signature");
    assertThat(refusals("in the name of insider")).hasSize(1);
    assertThat(centre.heard).isEmpty();
  }

  /** He has got hold of the files of one container, and speaks for an agent of another. */
  @Test
  void aForgedSenderIsRefusedThoughItsSignatureIsThatOfAContainer() throws Exception {
    ACLMessage forged = message(rose, "((perform (:feature unlock)))");
    forged.setSender(centre.getAID());
    seal(forged, rose, 1);
    insider.say(forged);
    awaitRefusal(
        "in the name of centre@signing was refused: it is signed by container-robots, where no"
            + " agent of that name lives");
    assertThat(rose.heard).isEmpty();
  }

  /** Not even that an agent of theirs ends; what JADE tells they may ask of MAESTRO's agents. */
  @Test
  void aGuestHasJadeItselfDoNothing() throws Exception {
    ACLMessage order = new ACLMessage(ACLMessage.REQUEST);
    order.addReceiver(visitor.getAMS());
    order.setLanguage("fipa-sl0");
    order.setOntology("JADE-Agent-Management");
    order.setContent(
        "((action %1$s (kill-agent :agent (agent-identifier :name %2$s))))"
            .formatted(
                "(agent-identifier :name " + visitor.getAMS().getName() + ")",
                rose.getAID().getName()));
    visitor.say(order);
    ACLMessage answer = visitor.next();
    assertThat(answer.getPerformative()).isEqualTo(ACLMessage.FAILURE);
    awaitRefusal("tablet is a guest, and guests have JADE itself do nothing");
    rose.say(message(centre, "((still here))"));
    assertThat(centre.next().getContent()).isEqualTo("((still here))");
  }

  /** While there is no supervisor its name is free, and a guest has taken it (A23). */
  @Test
  void aCentralAgentIsOneOfTheMainContainerAndNobodyElseIsHeardUnderItsName() throws Exception {
    impostor.say(message(rose, "(perform (:action move) (:container tablet))"));
    assertThat(impostor.next().getPerformative()).isEqualTo(ACLMessage.FAILURE);
    awaitRefusal("it is signed by tablet, and only the main container has one of that name");
    assertThat(rose.heard).isEmpty();
  }

  @Test
  void whatWasChangedAfterItWasSignedIsRefused() throws Exception {
    ACLMessage message = message(centre, "((perform (:feature dim)))");
    message.setSender(rose.getAID());
    seal(message, centre, 2);
    message.setContent("((perform (:feature unlock)))");
    insider.say(message);
    awaitRefusal("the signature of container-robots is not of this message");
    assertThat(centre.heard).isEmpty();
  }

  @Test
  void whatWasHeardBeforeIsRefusedTheSecondTime() throws Exception {
    ACLMessage message = message(centre, "((once))");
    message.setSender(rose.getAID());
    seal(message, centre, 3);
    insider.say(message);
    assertThat(centre.next().getContent()).isEqualTo("((once))");
    insider.say(message);
    awaitRefusal("it has come before");
    assertThat(centre.heard).isEmpty();
  }

  @Test
  void whatWasSignedForAnotherIsRefused() throws Exception {
    ACLMessage message = message(rose, "((for the centre))");
    message.setSender(rose.getAID());
    seal(message, centre, 4);
    insider.say(message);
    awaitRefusal("A message to rose@signing in the name of rose@signing was refused");
    assertThat(rose.heard).isEmpty();
  }

  private static void awaitRefusal(String part) {
    Awaitility.await().atMost(Duration.ofSeconds(20)).until(() -> !refusals(part).isEmpty());
  }

  private static List<String> refusals(String part) {
    return List.copyOf(log.list).stream()
        .map(ILoggingEvent::getFormattedMessage)
        .filter(line -> line.contains(part))
        .toList();
  }

  private static void seal(ACLMessage message, Speaker receiver, long number) {
    Seal seal = Seal.of(message, receiver.getAID(), "a-life", number, robotsAccess);
    message.addUserDefinedParameter(Seal.SLOT, seal.write());
  }

  private static ACLMessage message(Speaker receiver, String content) {
    ACLMessage message = new ACLMessage(ACLMessage.INFORM);
    message.addReceiver(receiver.getAID());
    message.setLanguage(Words.LANGUAGE);
    message.setContent(content);
    return message;
  }

  /** Says what it is told to, and keeps what it hears. */
  private static final class Speaker extends Agent {
    private static final long serialVersionUID = 1L;
    private final transient CountDownLatch ready = new CountDownLatch(1);
    private final transient BlockingQueue<ACLMessage> heard = new LinkedBlockingQueue<>();

    @Override
    protected void setup() {
      addBehaviour(new Hearing(this, heard::add));
      ready.countDown();
    }

    void say(ACLMessage message) {
      addBehaviour(
          new OneShotBehaviour(this) {
            private static final long serialVersionUID = 1L;

            @Override
            public void action() {
              send(message);
            }
          });
    }

    ACLMessage next() throws InterruptedException {
      ACLMessage message = heard.poll(20, TimeUnit.SECONDS);
      assertThat(message).as("a message to %s", getLocalName()).isNotNull();
      return message;
    }
  }
}
