package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.agents.runtime.Caller;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

/**
 * An agent that knows JADE only tells the central one what people say (ADE, 4.2), and what nobody
 * can have said is answered in one sentence.
 */
@Isolated("its time is wall time, which others beside it would take")
class SayMessageTest {
  private static LocalSite site;
  private static PlainAgent.Guest guest;

  @BeforeAll
  static void startSite() throws Exception {
    Home home = new HomeLoader().load(text("/homes/evening.ttl"), "evening.ttl");
    site =
        LocalSite.paced(
            SiteSettings.of("spoken", home)
                .scene(
                    SceneLoader.load(
                        "evening.ttl",
                        SayMessageTest.class.getResourceAsStream("/scenes/evening.ttl"),
                        home))
                .build(),
            20);
    guest = PlainAgent.join(Optional.of("spoken"), site.platform().port(), "GAC", "ear");
  }

  @AfterAll
  static void end() throws Exception {
    guest.close();
    site.close();
  }

  @Test
  void whatIsUnderstoodAsAGoalIsAgreedToAndItsEndIsTold() throws Exception {
    ACLMessage agree = answer("(say \"turn on the kitchen light\" (:by Dave) (:in bedroom))");
    assertThat(agree.getPerformative()).as(agree.toString()).isEqualTo(ACLMessage.AGREE);
    assertThat(agree.getContent())
        .contains("(:means \"(initCNP (:goal (= (level kitchen-lamp) 1)))\")")
        .containsPattern("\\(:goals G\\d+\\)");
    ACLMessage end = guest.agent().heard();
    assertThat(end.getPerformative()).isEqualTo(ACLMessage.INFORM);
    assertThat(end.getContent()).contains("(:state achieved)");
  }

  @Test
  void severalGoalsOfOneSentenceEndInOneMessage() throws Exception {
    ACLMessage agree =
        answer(
            "(say \"turn on the kitchen light and say hello to Rose\" (:by Dave) (:in hallway))");
    assertThat(agree.getPerformative()).as(agree.toString()).isEqualTo(ACLMessage.AGREE);
    assertThat(agree.getContent()).containsPattern("\\(:goals G\\d+ G\\d+\\)");
    ACLMessage end = guest.agent().heard();
    assertThat(end.getContent()).contains("(level kitchen-lamp)").contains("(greet Rose)");
  }

  @Test
  void aQuestionBackIsAnsweredByWhatTheSamePersonSaysNext() throws Exception {
    ACLMessage question = answer("(say \"turn on the lamp\" (:by Rose) (:in livingroom))");
    assertThat(question.getPerformative()).isEqualTo(ACLMessage.INFORM);
    assertThat(question.getContent())
        .isEqualTo(
            "(inform (:asks \"Which lamp, the ceiling light, the floor lamp or the reading"
                + " lamp?\"))");

    assertThat(answer("(say \"the reading lamp\" (:by Dave) (:in bedroom))").getPerformative())
        .as("nobody has asked Dave")
        .isNotEqualTo(ACLMessage.AGREE);
    ACLMessage agree = answer("(say \"the reading lamp\" (:by Rose))");
    assertThat(agree.getContent()).contains("(= (level reading-lamp) 1)");
    assertThat(guest.agent().heard().getPerformative()).isEqualTo(ACLMessage.INFORM);
  }

  @Test
  void aQuestionIsAnsweredWithWhatItMeans() throws Exception {
    ACLMessage answer = answer("(say \"is the stereo on?\" (:by Dave) (:in livingroom))");

    assertThat(answer.getPerformative()).isEqualTo(ACLMessage.INFORM);
    assertThat(answer.getContent())
        .isEqualTo("(inform (:means \"(query-if (switchedOn stereo))\") (:reply \"Yes.\"))");
  }

  /** A microphone tells each word; the last message is the whole sentence. */
  @Test
  void whatIsCertainIsBegunBeforeTheEnd() throws Exception {
    ACLMessage first = answer("(say \"turn on the\" (:by Rose) (:in bedroom) (:more true))");
    assertThat(first.getPerformative()).isEqualTo(ACLMessage.INFORM);
    assertThat(first.getContent()).isEqualTo("(inform (:nods false))");
    ACLMessage certain =
        answer("(say \"turn on the bathroom light\" (:by Rose) (:in bedroom) (:more true))");
    assertThat(certain.getContent())
        .matches("\\(inform \\(:looks bath-lamp\\) \\(:nods true\\) \\(:begun G\\d+\\)\\)");
    String begun = certain.getContent().replaceAll(".*begun (G\\d+).*", "$1");

    ACLMessage agree = answer("(say \"turn on the bathroom light please\" (:by Rose))");
    assertThat(agree.getPerformative()).as(agree.toString()).isEqualTo(ACLMessage.AGREE);
    assertThat(agree.getContent()).contains("(:goals " + begun + ")");
    assertThat(guest.agent().heard().getContent()).contains("(:state achieved)");
  }

  @Test
  void whatAGoalHasChangedIsTakenBack() throws Exception {
    assertThat(answer("(initCNP (:goal (= (level kids-lamp) 0.4)))").getContent())
        .contains("initCNP");
    String goal = guest.agent().heard().getContent().replaceAll("(?s).*?(G\\d+).*", "$1");

    assertThat(answer("(query-ref (:before %s))".formatted(goal)).getContent())
        .contains("(:before \"(= (level kids-lamp) 1)\")");
    assertThat(answer("(undo (:goal %s))".formatted(goal)).getPerformative())
        .isEqualTo(ACLMessage.AGREE);
    assertThat(guest.agent().heard().getContent()).contains("(= (level kids-lamp) 1)");
    assertRefused("(undo (:goal G9999))", "There is no goal G9999");
    assertRefused("(query-ref (:before G9999))", "There is no goal G9999");
    assertThat(answer("(undo)").getPerformative()).isEqualTo(ACLMessage.NOT_UNDERSTOOD);
  }

  @Test
  void whatIsAskedAboutGoalsIsForTheConsole() throws Exception {
    for (String said :
        List.of("what are you doing?", "try again", "stop", "why?", "what can you do here?")) {
      assertRefused(
          "(say \"%s\" (:by Dave) (:in bedroom))".formatted(said), "in the chat of the console");
    }
    assertRefused("(say \"yes\" (:by Dave) (:in bedroom))", "I did not understand");
  }

  @Test
  void whatIsAskedBackMayBeLeftSo() throws Exception {
    assertThat(answer("(say \"turn on the lamp\" (:by Grandma) (:in livingroom))").getContent())
        .contains("(:asks ");
    ACLMessage dropped = answer("(say \"never mind\" (:by Grandma))");
    assertThat(dropped.getPerformative()).isEqualTo(ACLMessage.INFORM);
    assertThat(dropped.getContent())
        .isEqualTo("(inform (:means \"(cancel (:question))\") (:reply \"All right.\"))");
  }

  @Test
  void whatNobodyCanHaveSaidIsAnsweredInOneSentence() throws Exception {
    assertRefused("(say \"turn it on\" (:by Dav))", "This home has no person Dav; write Dave");
    assertRefused("(say \"hi\" (:by Dave) (:in attic))", "This home has no room attic");
    assertRefused("(say \"%s\" (:by Dave))".formatted("light ".repeat(10_000)), "2000 characters");
    assertRefused("(say \"turn \u0007 on\" (:by Dave))", "which nobody can say");
    assertRefused("(say \"blorp the flim\" (:by Dave) (:in kitchen))", "blorp");
    assertNotUnderstood("(say \"\" (:by Dave))");
    assertNotUnderstood("(say \" \" (:by Dave))");
    assertNotUnderstood("(say \"turn on the light\")");
    assertNotUnderstood("(say (:by Dave))");
    ACLMessage told = request("(say \"turn on the light\" (:by Dave))");
    told.setPerformative(ACLMessage.INFORM);
    guest.agent().say(told);
    assertThat(guest.agent().heard().getPerformative()).isEqualTo(ACLMessage.NOT_UNDERSTOOD);
  }

  /** Of an agent of a secured site its user is proven, and may be a person of the home. */
  @Test
  void aPersonSpeaksForNobodyElse() throws Exception {
    ACLMessage message = request("(say \"is the stereo on?\" (:by Dave) (:in livingroom))");
    message.addUserDefinedParameter(Caller.USER_SLOT, "rose");
    guest.agent().say(message);
    ACLMessage refused = guest.agent().heard();
    assertThat(refused.getPerformative()).isEqualTo(ACLMessage.REFUSE);
    assertThat(refused.getContent()).contains("rose does not speak for Dave");

    ACLMessage another = request("(say \"is the stereo on?\" (:by Dave) (:in livingroom))");
    another.addUserDefinedParameter(Caller.USER_SLOT, "tablet");
    guest.agent().say(another);
    assertThat(guest.agent().heard().getPerformative()).isEqualTo(ACLMessage.INFORM);
  }

  private static void assertRefused(String content, String reason) throws Exception {
    ACLMessage reply = answer(content);
    assertThat(reply.getPerformative()).as(reply.toString()).isEqualTo(ACLMessage.REFUSE);
    assertThat(reply.getContent()).contains(reason).hasSizeLessThan(300);
  }

  private static void assertNotUnderstood(String content) throws Exception {
    ACLMessage reply = answer(content);
    assertThat(reply.getPerformative()).as(reply.toString()).isEqualTo(ACLMessage.NOT_UNDERSTOOD);
    assertThat(reply.getContent()).contains("such as (say ");
  }

  private static ACLMessage answer(String content) throws Exception {
    guest.agent().say(request(content));
    return guest.agent().heard();
  }

  private static ACLMessage request(String content) {
    ACLMessage request = new ACLMessage(ACLMessage.REQUEST);
    request.addReceiver(new AID("CCA", AID.ISLOCALNAME));
    request.setLanguage("MAESTRO-SL");
    request.setOntology("WorldModel");
    request.setProtocol("fipa-request");
    request.setContent(content);
    return request;
  }

  private static String text(String resource) throws IOException {
    try (InputStream stream = SayMessageTest.class.getResourceAsStream(resource)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
