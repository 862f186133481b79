package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.launch.JavaProcess;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.jade.Premises;
import org.maestro.platform.jade.SentMessage;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/**
 * The message that the paper prints in section 3.3.3, from an agent of another container that knows
 * JADE only (Three-layered architecture, 3.3.3; M74-M77). The platform is called MC as there, so
 * that the receiver's name is right as printed.
 */
@Isolated("its time is wall time, which others beside it would take")
class PapersMessageTest {

  private static final String GOAL = "(initCNP (:goal (canSee ?agent GreenObject)))";
  private static final String AS_PRINTED =
      """
      (request
        :sender (agent-identifier :name Rose@RAC)
        :receiver (set (agent-identifier :name %s))
        :ontology WorldModel
        :language MAESTRO-SL
        :protocol fipa-request
        :content "%s")
      """;

  /** The goal with the agent filled in, and the same agent as its binding. */
  private static final Pattern ANSWER =
      Pattern.compile("\\(canSee (cam-[1-3]) GreenObject\\)\\) \\(:binding \\(:agent \\1\\)\\)");

  private static LocalSite site;
  private static PlainAgent.Guest guest;
  private static final List<SentMessage> asked = new CopyOnWriteArrayList<>();

  @BeforeAll
  static void startSite() throws Exception {
    Home home = new HomeLoader().load(text("/homes/arena.ttl"), "arena.ttl");
    Scene scene =
        SceneLoader.load(
            "arena-dark.ttl",
            PapersMessageTest.class.getResourceAsStream("/scenes/arena-dark.ttl"),
            home);
    Premises.LetterBox letters = new Premises.LetterBox("127.0.0.1", 0);
    site =
        LocalSite.paced(
            SiteSettings.of("MC", home)
                .scene(scene)
                .premises(Premises.usual().with(Optional.of(letters)))
                .build(),
            20);
    site.platform().onMail(asked::add);
    guest = PlainAgent.join(Optional.of("MC"), site.platform().port(), "GAC", "Guest");
  }

  @AfterAll
  static void end() throws Exception {
    guest.close();
    site.close();
  }

  @Test
  void theMessageIsAgreedToAndAnsweredWithTheAgentThatSees() throws Exception {
    guest.agent().say(request(new AID("CCA@MC", AID.ISGUID), GOAL));

    assertAnswered();
  }

  @Test
  void doubledQuotesAsPrintedAreNoObstacle() throws Exception {
    guest.agent().say(request(new AID("CCA@MC", AID.ISGUID), "\"\"" + GOAL + "\"\""));

    assertAnswered();
  }

  @Test
  void theWrittenFormIsUnderstood() throws Exception {
    guest.agent().say(PlainAgent.written(AS_PRINTED.formatted("CCA@MC", GOAL)));

    assertAnswered();
  }

  /** Names, all parts and the content are those of the paper, before it is sent and after. */
  @Test
  void exactlyThePrintedMessageComesFromRoseAndGoesRoundUnchanged(@TempDir Path files)
      throws Exception {
    ACLMessage printed = PlainAgent.written(AS_PRINTED.formatted("CCA@MC", GOAL));
    ACLMessage again = PlainAgent.written(printed.toString());

    assertThat(parts(again))
        .isEqualTo(parts(printed))
        .containsExactly(
            "REQUEST",
            "Rose@RAC",
            "CCA@MC",
            "WorldModel",
            "MAESTRO-SL",
            "fipa-request",
            "(initCNP (:goal (canSee ?agent GreenObject)))");
    assertThat(SlPrinter.print(SlParser.content(GOAL, name -> false).get(0))).isEqualTo(GOAL);

    PlainAgent.Guest rose = PlainAgent.platform("RAC", "Rose", files);
    try {
      // Where the other platform is stands beside its agent's name, as the paper leaves it out.
      ((AID) printed.getAllReceiver().next())
          .addAddresses(site.platform().premises().letters().orElseThrow().url());
      rose.agent().send(printed);

      assertAnswered(rose);
    } finally {
      rose.close();
    }
    assertThat(asked)
        .anySatisfy(
            message -> {
              assertThat(message.sender()).isEqualTo("Rose@RAC");
              assertThat(message.receiver()).isEqualTo("CCA@MC");
              assertThat(message.performative()).isEqualTo("request");
              assertThat(message.protocol()).contains("fipa-request");
              assertThat(message.content()).isEqualTo(GOAL);
            });
  }

  private static List<String> parts(ACLMessage message) {
    return List.of(
        ACLMessage.getPerformative(message.getPerformative()),
        message.getSender().getName(),
        ((AID) message.getAllReceiver().next()).getName(),
        message.getOntology(),
        message.getLanguage(),
        message.getProtocol(),
        message.getContent());
  }

  @Test
  void anotherProcessMayAsk() throws Exception {
    try (JavaProcess process =
        JavaProcess.start(
            PlainAgentProcess.class.getName(),
            List.of(
                String.valueOf(site.platform().port()), AS_PRINTED.formatted("CCA@MC", GOAL)))) {
      JavaProcess.Ended ended = process.await(Duration.ofSeconds(40));

      assertThat(ended.exitCode()).as(ended.errors()).isZero();
      assertThat(ended.output().lines().filter(line -> line.matches("[A-Z]+ \\(.*")))
          .satisfiesExactly(
              agree -> assertThat(agree).startsWith("AGREE (initCNP (:goal G"),
              inform -> assertThat(inform).startsWith("INFORM ").containsPattern(ANSWER));
    }
  }

  @Test
  void malformedContentIsNotUnderstoodAndItsColumnTold() throws Exception {
    guest.agent().say(request(new AID("CCA@MC", AID.ISGUID), "(initCNP (:goal (canSee ?agent"));

    ACLMessage reply = guest.agent().heard();
    assertThat(reply.getPerformative()).isEqualTo(ACLMessage.NOT_UNDERSTOOD);
    assertThat(reply.getContent()).contains("At column 31");
    assertThat(reply.getLanguage()).isEqualTo("MAESTRO-SL");
  }

  @Test
  void missingContentIsNotUnderstood() throws Exception {
    guest.agent().say(request(new AID("CCA@MC", AID.ISGUID), null));

    assertThat(guest.agent().heard().getPerformative()).isEqualTo(ACLMessage.NOT_UNDERSTOOD);
  }

  @Test
  void anUnknownThingIsRefusedWithTheReason() throws Exception {
    guest
        .agent()
        .say(
            request(new AID("CCA@MC", AID.ISGUID), "(initCNP (:goal (canSee ?agent BlueObject)))"));

    ACLMessage reply = guest.agent().heard();
    assertThat(reply.getPerformative()).isEqualTo(ACLMessage.REFUSE);
    assertThat(reply.getContent()).contains("BlueObject");
  }

  @Test
  void anUnknownOperatorIsNotUnderstoodAndTheKnownOnesTold() throws Exception {
    guest
        .agent()
        .say(
            request(
                new AID("CCA@MC", AID.ISGUID), "(startCNP (:goal (canSee cam-1 GreenObject)))"));

    ACLMessage reply = guest.agent().heard();
    assertThat(reply.getPerformative()).isEqualTo(ACLMessage.NOT_UNDERSTOOD);
    assertThat(reply.getContent()).contains("startCNP").contains("initCNP");
  }

  @Test
  void aGoalThatIsNotRequestedIsNotUnderstood() throws Exception {
    ACLMessage rejection = request(new AID("CCA@MC", AID.ISGUID), GOAL);
    rejection.setPerformative(ACLMessage.REJECT_PROPOSAL);
    guest.agent().say(rejection);

    ACLMessage reply = guest.agent().heard();
    assertThat(reply.getPerformative()).isEqualTo(ACLMessage.NOT_UNDERSTOOD);
    assertThat(reply.getContent()).contains("REJECT-PROPOSAL");
  }

  private void assertAnswered() throws InterruptedException {
    assertAnswered(guest);
  }

  private void assertAnswered(PlainAgent.Guest guest) throws InterruptedException {
    ACLMessage agree = guest.agent().heard();
    assertThat(agree.getPerformative()).as(agree.toString()).isEqualTo(ACLMessage.AGREE);
    assertThat(agree.getProtocol()).isEqualTo("fipa-request");
    ACLMessage inform = guest.agent().heard();
    assertThat(inform.getPerformative()).as(inform.toString()).isEqualTo(ACLMessage.INFORM);
    assertThat(inform.getContent()).containsPattern(ANSWER);
    assertThat(inform.getLanguage()).isEqualTo("MAESTRO-SL");
    assertThat(inform.getOntology()).isEqualTo("WorldModel");
  }

  private static ACLMessage request(AID receiver, String content) {
    ACLMessage request = new ACLMessage(ACLMessage.REQUEST);
    request.addReceiver(receiver);
    request.setOntology("WorldModel");
    request.setLanguage("MAESTRO-SL");
    request.setProtocol("fipa-request");
    request.setContent(content);
    return request;
  }

  private static String text(String resource) {
    try (InputStream stream = PapersMessageTest.class.getResourceAsStream(resource)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
