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
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.CoordinatorAgent;
import org.maestro.agents.GroupAgent;
import org.maestro.agents.KnowledgeAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.goals.Past;
import org.maestro.agents.goals.ReasoningServices;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.Spokesmen;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.Deployment;
import org.maestro.dialogue.Dialogues;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.habits.HabitLog;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.home.Individual;
import org.maestro.planning.OptimalPlanner;
import org.maestro.rats.time.SteppedClock;

/**
 * Who may use which part of which agent (ADE, 3.1; A26, A29), and what becomes of one whose right
 * is taken away (A28).
 */
class PartsTest {
  private static final List<String> CALLERS =
      List.of("listener", "librarian", "steward", "teller", "friend", "thief");

  /** What is asked of whom, by the part that it needs. */
  private static final Map<String, Call> CALLS =
      new TreeMap<>(
          Map.of(
              "administration",
              new Call(AgentNames.COORDINATOR, ACLMessage.REQUEST, "(perform (:action revive))"),
              "goals",
              new Call(AgentNames.COORDINATOR, ACLMessage.REQUEST, "(cancel (:goal G99))"),
              "memory",
              new Call(AgentNames.KNOWLEDGE, ACLMessage.QUERY_IF, "(query-if (greeted Bob))"),
              "stories",
              new Call(AgentNames.COORDINATOR, ACLMessage.REQUEST, "(explain (:goal G99))"),
              "telling",
              new Call(
                  AgentNames.KNOWLEDGE,
                  ACLMessage.REQUEST,
                  "(inform (:source somebody) (:facts \"(guided Bob)\"))"),
              "understanding",
              new Call(
                  AgentNames.COORDINATOR,
                  ACLMessage.REQUEST,
                  "(say \"Greet Bob\" (:by Nobody) (:in hall))"),
              "goals of keeper",
              new Call("keeper", ACLMessage.REQUEST, "(cancel (:goal keeper-99))")));

  @TempDir static Path files;
  private static final SteppedClock CLOCK = new SteppedClock();
  private static final Map<String, Guest> GUESTS = new TreeMap<>();
  private static final Deployment DEPLOYMENT = new Deployment();
  private static String greeters;
  private static CollectiveKnowledge knowledge;
  private static BareJade jade;
  private static Guest usher;

  private record Call(String agent, int performative, String content) {}

  @BeforeAll
  static void start() throws IOException, InterruptedException {
    greeters =
        Files.readString(Path.of("src/test/resources/greeters.ttl"))
            + """
            home:keeper a maestro:GroupAgent ; rdfs:label "the keeper"@en ;
              maestro:member home:usher ; maestro:pursues "(greeted Bob)" .
            home:p1 a maestro:Permission ; maestro:caller "listener" ;
              maestro:opens maestro:understanding .
            home:p3 a maestro:Permission ; maestro:caller "steward" ;
              maestro:opens maestro:goals , maestro:administration .
            home:p4 a maestro:Permission ; maestro:caller "teller" ; maestro:opens maestro:telling .
            home:p5 a maestro:Permission ; maestro:caller "friend" ; maestro:asks home:keeper ;
              maestro:opens maestro:goals .
            home:p6 a maestro:Permission ; maestro:caller "steward" ; maestro:asks :Greeter .
            """;
    Home home =
        home(
            "home:p2 a maestro:Permission ; maestro:caller \"librarian\" ;"
                + " maestro:opens maestro:memory , maestro:stories .");
    knowledge = new CollectiveKnowledge(home, CLOCK);
    jade = new BareJade("parts", files);
    AgentTime time = AgentTime.of(CLOCK);
    Spokesmen spokesmen = new DeployedSpokesmen(DEPLOYMENT, knowledge::home, user -> false);
    BareJade.start(
        jade.main(),
        AgentNames.KNOWLEDGE,
        new KnowledgeAgent(
            jade.birth(),
            time,
            knowledge,
            (description, member) -> home.devices().get(member),
            HabitLog.NONE,
            spokesmen));
    Dialogues dialogues = new Dialogues(knowledge::home, knowledge::snapshot, CLOCK::instant);
    BareJade.start(
        jade.main(),
        AgentNames.COORDINATOR,
        new CoordinatorAgent(
            jade.birth(),
            time,
            knowledge,
            new OptimalPlanner(),
            entry -> {},
            Duration.ZERO,
            Past.none(),
            dialogues,
            List.of(),
            spokesmen));
    BareJade.start(
        jade.main(),
        "keeper",
        new GroupAgent(
            jade.birth(),
            time,
            new ReasoningServices(knowledge, new OptimalPlanner(), Duration.ZERO),
            home.groups().get("keeper"),
            entry -> {},
            Past.none(),
            dialogues,
            spokesmen));
    for (String caller : CALLERS) {
      GUESTS.put(caller, guest(caller));
    }
    DEPLOYMENT.placed(AgentStart.of("usher", "greeters"));
    usher = guest("usher");
  }

  @AfterAll
  static void end() {
    jade.close();
    knowledge.close();
  }

  private static Home home(String permissions) {
    return new HomeLoader().load(greeters + permissions, "greeters.ttl");
  }

  private static Guest guest(String name) throws InterruptedException {
    Guest guest = new Guest(jade.birth(), AgentTime.of(CLOCK));
    BareJade.start(jade.main(), name, guest);
    assertThat(guest.awaitStart(Duration.ofSeconds(60))).isTrue();
    return guest;
  }

  private static void permit(String permissions) {
    Map<String, Individual> stated = home(permissions).permissions();
    knowledge.permit(stated);
  }

  @Test
  void eachPartOfEachAgentHasAListOfItsOwn() {
    List<String> admitted = new ArrayList<>();
    for (String caller : CALLERS) {
      CALLS.forEach(
          (part, call) -> {
            ACLMessage reply = GUESTS.get(caller).ask(call);
            boolean isRefused = reply.getContent().contains("no maestro:Permission of the home");
            if (isRefused) {
              assertThat(reply.getPerformative()).isEqualTo(ACLMessage.REFUSE);
              assertThat(reply.getContent()).contains("opens the ", " to " + caller);
            } else {
              admitted.add(caller + ": " + part);
            }
          });
    }
    assertThat(admitted)
        .containsExactly(
            "listener: understanding",
            "librarian: memory",
            "librarian: stories",
            "steward: administration",
            "steward: goals",
            "steward: goals of keeper",
            "teller: telling",
            "friend: goals of keeper");
  }

  @Test
  void whoseRightIsTakenAwayIsRefusedAtTheNextCall() {
    Call question = CALLS.get("memory");
    assertThat(GUESTS.get("librarian").ask(question).getPerformative())
        .isEqualTo(ACLMessage.INFORM);
    permit(
        "home:p2 a maestro:Permission ; maestro:caller \"thief\" ; maestro:opens maestro:memory .");
    assertThat(GUESTS.get("librarian").ask(question).getPerformative())
        .isEqualTo(ACLMessage.REFUSE);
    assertThat(GUESTS.get("thief").ask(question).getPerformative()).isEqualTo(ACLMessage.INFORM);
    permit(
        "home:p2 a maestro:Permission ; maestro:caller \"librarian\" ;"
            + " maestro:opens maestro:memory , maestro:stories .");
    assertThat(GUESTS.get("librarian").ask(question).getPerformative())
        .isEqualTo(ACLMessage.INFORM);
  }

  /** The agent of a device need not come anew, and may be in another process. */
  @Test
  void theAgentOfADeviceIsToldOtherRightsAtOnce() {
    Call introduction =
        new Call(
            AgentNames.KNOWLEDGE,
            ACLMessage.REQUEST,
            "(inform (:member usher) (:description \"as the home says\"))");
    assertThat(usher.ask(introduction).getContent())
        .contains("(:permission (:caller \"steward\") (:permits))");
    permit(
        """
        home:p2 a maestro:Permission ; maestro:caller "librarian" ;
          maestro:opens maestro:memory , maestro:stories .
        home:p7 a maestro:Permission ; maestro:caller "friend" ; maestro:asks home:usher ;
          maestro:permits :greet .
        """);
    ACLMessage told = usher.next("other rights");
    assertThat(told.getPerformative()).isEqualTo(ACLMessage.REQUEST);
    assertThat(told.getContent())
        .startsWith("(permit (:member usher)")
        .contains("(:caller \"friend\") (:permits \"greet\")");
    usher.tell(() -> usher.send(done(told)));
    permit(
        "home:p2 a maestro:Permission ; maestro:caller \"librarian\" ;"
            + " maestro:opens maestro:memory , maestro:stories .");
    assertThat(usher.next("other rights").getContent()).doesNotContain("friend");
  }

  private static ACLMessage done(ACLMessage request) {
    ACLMessage reply = request.createReply();
    reply.setPerformative(ACLMessage.INFORM);
    reply.setContent("(inform (:done permit))");
    return reply;
  }

  /** Asks, and keeps all that it hears. */
  private static final class Guest extends MaestroAgent {
    private static final long serialVersionUID = 1L;
    private final transient List<ACLMessage> heard =
        Collections.synchronizedList(new ArrayList<>());
    private int number;
    private int seen;

    Guest(Birth birth, AgentTime time) {
      super(birth, time);
    }

    @Override
    protected void received(ACLMessage message) {
      // The keeper asks for its member again and again.
      if (message.getPerformative() != ACLMessage.SUBSCRIBE) {
        heard.add(message);
      }
    }

    /** The first that comes after this. */
    ACLMessage ask(Call call) {
      seen = heard.size();
      String conversation = getLocalName() + "-asks-" + ++number;
      tell(
          () -> {
            ACLMessage question =
                message(call.performative(), new AID(call.agent(), AID.ISLOCALNAME));
            question.setConversationId(conversation);
            question.setContent(call.content());
            send(question);
          });
      return next(call.content());
    }

    ACLMessage next(String what) {
      await(what)
          .atMost(Duration.ofSeconds(60))
          .until(
              () -> {
                CLOCK.run(Duration.ofMillis(100));
                return heard.size() > seen;
              });
      return heard.get(seen++);
    }
  }
}
