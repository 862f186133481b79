package org.maestro.platform;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.KnowledgeAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.time.SteppedClock;

/** Private facts are told to those alone whom the home permits that (ADE, 4.1; A30, A57). */
class PrivateFactsTest {
  private static final Path LIVINGROOM =
      Path.of("../scenarios/assembly/src/main/resources/homes/livingroom.ttl");
  private static final String NURSE_READS =
      "home:told a maestro:Permission ; maestro:caller \"nurse\" ; maestro:reads :prefers .";

  @TempDir Path files;
  private final SteppedClock clock = new SteppedClock();
  private final List<AutoCloseable> open = new ArrayList<>();
  private CollectiveKnowledge knowledge;
  private BareJade jade;

  private static Home home(String permissions) throws IOException {
    String text = Files.readString(LIVINGROOM).replaceAll("(?m)^.*maestro:private.*$", "");
    return new HomeLoader()
        .load(text + ":prefers maestro:private true .\n" + permissions, "livingroom.ttl");
  }

  private void start(String permissions) throws IOException {
    Home home = home(permissions);
    knowledge = new CollectiveKnowledge(home, clock);
    jade = new BareJade("private", files);
    open.add(jade);
    open.add(knowledge);
    BareJade.start(
        jade.main(),
        AgentNames.KNOWLEDGE,
        new KnowledgeAgent(
            jade.birth(),
            AgentTime.of(clock),
            knowledge,
            (description, member) -> home.devices().get(member)));
  }

  private Guest guest(String name) {
    Guest guest = new Guest(jade.birth(), AgentTime.of(clock));
    BareJade.start(jade.main(), name, guest);
    return guest;
  }

  @AfterEach
  void end() throws Exception {
    for (AutoCloseable part : open) {
      part.close();
    }
  }

  @Test
  void whoIsPermittedIsToldAndNobodyElse() throws IOException {
    start(NURSE_READS);
    Guest nurse = guest("nurse");
    Guest thief = guest("thief");
    assertThat(nurse.ask("n1", ACLMessage.QUERY_REF, "(query-ref (prefers dave-evenings ?show))"))
        .singleElement()
        .asString()
        .contains("(:binding (:show Opera))", "(:source \"livingroom.ttl\") (:kind described)");
    String[] questions = {
      "(query-ref (prefers dave-evenings ?show))",
      "(query-ref (exists (?p - Preference) (and (preferenceOf ?p Dave) (prefers ?p ?show))))",
      "(query-ref (:history \"(prefers dave-evenings Opera)\"))",
      "(query-ref (:last \"(prefers dave-evenings Opera)\"))",
      "(query-ref (prefers dave-evenings ?show) (:for \"nurse\"))"
    };
    for (int number = 0; number < questions.length; number++) {
      assertRefused(thief.ask("q" + number, ACLMessage.QUERY_REF, questions[number]));
    }
    assertRefused(
        thief.ask("if", ACLMessage.QUERY_IF, "(query-if (not (prefers dave-evenings Opera)))"));
    assertRefused(
        thief.ask("s", ACLMessage.SUBSCRIBE, "(subscribe (prefers dave-evenings ?show))"));
    assertThat(thief.ask("other", ACLMessage.QUERY_REF, "(query-ref (preferenceOf ?p Eve))"))
        .singleElement()
        .asString()
        .contains("eve-evenings");
    assertRefused(
        guest(AgentNames.DESK)
            .ask("d", ACLMessage.QUERY_REF, "(query-ref (prefers dave-evenings ?show))"));
  }

  private static void assertRefused(List<String> heard) {
    assertThat(heard)
        .singleElement()
        .asString()
        .startsWith("REFUSE")
        .contains("prefers is private in this home, and no maestro:Permission lets ")
        .doesNotContain("Opera", "News", "Cartoons");
  }

  /** A right that is taken away mid-session is gone at the next word (A28). */
  @Test
  void whoseRightToReadIsTakenAwayIsToldNothingMore() throws IOException {
    start(NURSE_READS);
    Guest nurse = guest("nurse");
    String question = "(prefers dave-evenings ?show)";
    nurse.ask("s", ACLMessage.SUBSCRIBE, "(subscribe " + question + ")");
    assertThat(nurse.awaited("s", 2)).last().asString().contains("(:show Opera)");
    knowledge.permit(home(NURSE_READS.replace("nurse", "doctor")).permissions());
    knowledge.state(
        new Source(Source.Kind.STATED, "somebody"), List.of("(prefers dave-evenings News)"));
    assertThat(nurse.awaited("s", 3).subList(2, 3))
        .singleElement()
        .asString()
        .startsWith("REFUSE")
        .doesNotContain("News");
    assertRefused(nurse.ask("q", ACLMessage.QUERY_REF, "(query-ref " + question + ")"));
  }

  @Test
  void listsLeavePrivateFactsOutAndSayHowMany() throws IOException {
    start(NURSE_READS);
    knowledge.state(
        new Source(Source.Kind.STATED, "somebody"),
        List.of("(prefers dave-evenings News)", "(prefers eve-evenings Opera)"));
    knowledge.state(new Source(Source.Kind.STATED, "lamp-1"), List.of("(= (level lamp-1) 0.5)"));

    List<String> heard = guest("thief").ask("l1", ACLMessage.QUERY_REF, "(query-ref)");
    assertThat(heard)
        .singleElement()
        .asString()
        .contains("(level lamp-1)")
        .endsWith("(:left-out 2) (:reason \"2 facts are private and left out.\"))")
        .doesNotContain("prefers");
    assertThat(guest("nurse").ask("l2", ACLMessage.QUERY_REF, "(query-ref)"))
        .singleElement()
        .asString()
        .contains("(level lamp-1)", "prefers dave-evenings News")
        .doesNotContain("left-out");
  }

  /** What nothing but a private fact names is no value of any variable. */
  @Test
  void whatOnlyPrivateFactsNameIsNoAnswerToOtherQuestions() throws IOException {
    start(NURSE_READS);
    knowledge.state(
        new Source(Source.Kind.STATED, "somebody"), List.of("(prefers dave-evenings Secret)"));
    String question = "(query-ref (not (looksLike Eve ?what)))";
    assertThat(guest("nurse").ask("v1", ACLMessage.QUERY_REF, question).toString())
        .contains("Secret");
    assertThat(guest("thief").ask("v2", ACLMessage.QUERY_REF, question).toString())
        .contains("deep-voice")
        .doesNotContain("Secret");
  }

  /** Who reads is not stated: the desk of an open site is at the machine itself. */
  @Test
  void whereTheHomeNamesNobodyTheDeskAloneIsTold() throws IOException {
    start("");
    assertThat(
            guest(AgentNames.DESK)
                .ask("d", ACLMessage.QUERY_REF, "(query-ref (prefers dave-evenings ?show))"))
        .singleElement()
        .asString()
        .contains("(:show Opera)");
    assertRefused(
        guest("tablet-desk")
            .ask("t", ACLMessage.QUERY_REF, "(query-ref (prefers dave-evenings ?show))"));
  }

  /** The desk asks for persons who have signed in, and each is told what she may be told. */
  @Test
  void theDeskIsToldWhatItsPersonMayRead() throws IOException {
    start(NURSE_READS);
    Guest desk = guest(AgentNames.DESK);
    String question = "(query-ref (prefers dave-evenings ?show) (:for \"%s\"))";
    assertThat(desk.ask("p1", ACLMessage.QUERY_REF, question.formatted("nurse")))
        .singleElement()
        .asString()
        .contains("(:show Opera)");
    assertRefused(desk.ask("p2", ACLMessage.QUERY_REF, question.formatted("mallory")));
  }

  /** Asks in a conversation, and keeps all that it hears there. */
  private final class Guest extends MaestroAgent {
    private static final long serialVersionUID = 1L;
    private final transient List<String> heard = Collections.synchronizedList(new ArrayList<>());

    Guest(Birth birth, AgentTime time) {
      super(birth, time);
    }

    @Override
    protected void received(ACLMessage message) {
      heard.add(
          message.getConversationId()
              + " "
              + ACLMessage.getPerformative(message.getPerformative())
              + " "
              + message.getContent());
    }

    List<String> ask(String conversation, int performative, String content) {
      tell(
          () -> {
            ACLMessage question =
                message(performative, new AID(AgentNames.KNOWLEDGE, AID.ISLOCALNAME));
            question.setConversationId(conversation);
            question.setContent(content);
            send(question);
          });
      return awaited(conversation, 1);
    }

    /** All that was heard in the conversation, as soon as it is so much. */
    List<String> awaited(String conversation, int atLeast) {
      await()
          .until(
              () -> {
                clock.run(Duration.ofMillis(100));
                return heardIn(conversation).size() >= atLeast;
              });
      return heardIn(conversation);
    }

    private List<String> heardIn(String conversation) {
      return List.copyOf(heard).stream()
          .filter(line -> line.startsWith(conversation + " "))
          .map(line -> line.substring(conversation.length() + 1))
          .toList();
    }
  }
}
