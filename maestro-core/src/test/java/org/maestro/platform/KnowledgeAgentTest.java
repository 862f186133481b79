package org.maestro.platform;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import jade.wrapper.AgentContainer;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
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
import org.maestro.platform.jade.ContainerEnds;
import org.maestro.platform.jade.JadeRuntime;
import org.maestro.platform.jade.Sockets;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** What the knowledge agent tells those who ask and those who subscribe. */
class KnowledgeAgentTest {
  private static final Source CAMERA = new Source(Source.Kind.OBSERVED, "cam-b");

  @TempDir static Path files;
  private static AgentContainer main;
  private static SteppedClock clock;
  private static CollectiveKnowledge knowledge;
  private static Guest guest;

  @BeforeAll
  static void start() {
    clock = new SteppedClock();
    Home home =
        new HomeLoader().load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"));
    knowledge = new CollectiveKnowledge(home, clock);
    main = JadeRuntime.main("knowing", Sockets.claim(0), files);
    AgentTime time = AgentTime.of(clock);
    JadeRuntime.start(
        main,
        AgentNames.KNOWLEDGE,
        new KnowledgeAgent(
            Birth.of(main), time, knowledge, (text, member) -> home.devices().get(member)));
    guest = new Guest(Birth.of(main), time);
    JadeRuntime.start(main, "guest", guest);
  }

  @AfterAll
  static void end() {
    ContainerEnds.end(main);
    knowledge.close();
  }

  @Test
  void questionsAreAnsweredWithTruthAgeSourceAndHistory() {
    assertThat(guest.ask("a1", ACLMessage.QUERY_IF, "(query-if (in Bob zone-b))"))
        .containsExactly("INFORM (inform (:truth unknown) (:confidence 1))");
    knowledge.state(CAMERA, List.of("(in Bob zone-a)"));
    clock.run(Duration.ofSeconds(10));

    assertThat(guest.ask("a2", ACLMessage.QUERY_IF, "(query-if (in Bob zone-b))"))
        .singleElement()
        .asString()
        .startsWith("INFORM (inform (:truth false) (:age 10")
        .contains("(:fact \"(in Bob zone-a)\") (:source \"cam-b\") (:kind observed)");
    assertThat(guest.ask("a3", ACLMessage.QUERY_IF, "(query-if (in Bob zone-b) (:within 5))"))
        .singleElement()
        .asString()
        .contains("(:truth unknown)");
    assertThat(guest.ask("a4", ACLMessage.QUERY_REF, "(query-ref (in Bob ?where))"))
        .singleElement()
        .asString()
        .contains("(:binding (:where zone-a))");

    clock.run(Duration.ofSeconds(25));
    assertThat(guest.ask("a5", ACLMessage.QUERY_REF, "(query-ref (in Bob ?where))"))
        .containsExactly("INFORM (inform (:answers none))");
    assertThat(guest.ask("a6", ACLMessage.QUERY_REF, "(query-ref (:last \"(in Bob zone-a)\"))"))
        .singleElement()
        .asString()
        .contains("(:fact \"(in Bob zone-a)\")");
    assertThat(guest.ask("a7", ACLMessage.QUERY_REF, "(query-ref (:history \"(in Bob zone-a)\"))"))
        .singleElement()
        .asString()
        .contains("(:source \"cam-b\")", "(:confidence 1)", "(:since \"2026-01-01T");
  }

  /** A typing error of a maker, and a thing in the wrong place of a word. */
  @Test
  void whatCannotBeSoIsPassedOverAndWhatStandsBesideItCounts() {
    Guest lamp = new Guest(Birth.of(main), AgentTime.of(clock));
    JadeRuntime.start(main, "lamp-b1", lamp);
    String told =
        "(inform (:source lamp-b1) (:facts \"(in zone-b Cup)\" \"(levl lamp-b1)\""
            + " \"(= (level lamp-b1) 0.5)\" \"(in parcel-7 zone-b)\"))";
    assertThat(guest.ask("w0", ACLMessage.REQUEST, told))
        .singleElement()
        .asString()
        .startsWith("REFUSE")
        .contains("does not speak for lamp-b1; its own agent does");
    lamp.ask("w1", ACLMessage.REQUEST, told);
    await()
        .until(
            () -> {
              clock.run(Duration.ofMillis(100));
              return !lamp.heard("w1").isEmpty();
            });

    assertThat(knowledge.snapshot().claims(atom("(in zone-b Cup)"))).isEmpty();
    assertThat(knowledge.snapshot().claims(atom("(levl lamp-b1)"))).isEmpty();
    assertThat(knowledge.snapshot().truth(atom("(in parcel-7 zone-b)"))).isEqualTo(Truth.TRUE);
    assertThat(
            knowledge
                .snapshot()
                .number(new Expression.Fluent("level", List.of(new Term.Name("lamp-b1")))))
        .hasValue(0.5);
  }

  private static Formula.Atom atom(String text) {
    return ((Fact.Holds) SlParser.fact(text)).atom();
  }

  @Test
  void whatCannotBeAnsweredIsRefusedHoweverItIsAsked() {
    String wrong = "The question names zone-b where a Thing is wanted, and it is none";
    assertThat(guest.ask("r1", ACLMessage.QUERY_IF, "(query-if (in zone-b Cup))"))
        .singleElement()
        .asString()
        .startsWith("REFUSE")
        .contains(wrong);
    assertThat(guest.ask("r2", ACLMessage.QUERY_REF, "(query-ref (in zone-b ?where))"))
        .singleElement()
        .asString()
        .startsWith("REFUSE")
        .contains(wrong);
    assertThat(guest.ask("r3", ACLMessage.SUBSCRIBE, "(subscribe (in zone-b ?where))"))
        .singleElement()
        .asString()
        .startsWith("REFUSE")
        .contains(wrong);
    assertThat(guest.ask("r4", ACLMessage.QUERY_REF, "(query-ref (:last \"(in zone-b Cup)\"))"))
        .singleElement()
        .asString()
        .startsWith("REFUSE")
        .contains(wrong);
    assertThat(guest.ask("r5", ACLMessage.QUERY_REF, "(query-ref Cup)"))
        .singleElement()
        .asString()
        .startsWith("REFUSE")
        .contains("A question needs a formula");
    assertThat(guest.ask("r6", ACLMessage.QUERY_IF, "(query-if (in Cup zone-b) (:within soon))"))
        .singleElement()
        .asString()
        .startsWith("REFUSE")
        .contains("no number of seconds");
  }

  @Test
  void aNumberIsAnsweredWithItsValue() {
    knowledge.state(new Source(Source.Kind.STATED, "lamp-b1"), List.of("(= (level lamp-b1) 0.25)"));

    assertThat(guest.ask("n1", ACLMessage.QUERY_REF, "(query-ref (= (level lamp-b1) ?n))"))
        .singleElement()
        .asString()
        .contains("(:binding (:n 0.25))", "(:source \"lamp-b1\")");
    assertThat(guest.ask("n2", ACLMessage.SUBSCRIBE, "(subscribe (level lamp-b1))"))
        .hasSize(2)
        .last()
        .asString()
        .contains("(:binding (:value 0.25))");
    assertThat(guest.ask("n3", ACLMessage.QUERY_IF, "(query-if (level lamp-b1))"))
        .singleElement()
        .asString()
        .contains("(:truth true) (:binding (:value 0.25))");
  }

  @Test
  void twoCamerasThatDisagreeAreBothShownWithTheRule() {
    knowledge.state(new Source(Source.Kind.OBSERVED, "cam-a"), List.of("(position Cup \"1 1 0\")"));
    knowledge.state(CAMERA, List.of("(position Cup \"1.5 1 0\")"));

    assertThat(guest.ask("d1", ACLMessage.QUERY_REF, "(query-ref (:disputes))"))
        .singleElement()
        .asString()
        .contains(
            "(:believed (:fact \"(position Cup \\\"1.5 1 0\\\")\") (:source \"cam-b\")",
            "(:loser (:fact \"(position Cup \\\"1 1 0\\\")\") (:source \"cam-a\")",
            "what was received later counts");
  }

  @Test
  void whoSubscribesIsToldWhenTheAnswerChangesAlsoByAgeAndNotAfterCancel() {
    assertThat(guest.ask("s1", ACLMessage.SUBSCRIBE, "(subscribe (in rose zone-b))"))
        .extracting(heard -> heard.split(" ")[0])
        .containsExactly("AGREE", "INFORM");

    knowledge.state(CAMERA, List.of("(in rose zone-b)"));
    knowledge.state(CAMERA, List.of("(in rose zone-b)"));
    clock.run(Duration.ofSeconds(1));
    assertThat(guest.heard("s1")).hasSize(3).last().asString().contains("(:truth true)");

    clock.run(Duration.ofMinutes(11));
    assertThat(guest.heard("s1")).hasSize(4).last().asString().contains("(:truth unknown)");

    guest.ask("s1", ACLMessage.CANCEL, "(cancel)");
    int before = guest.heard("s1").size();
    knowledge.state(CAMERA, List.of("(in rose zone-a)"));
    clock.run(Duration.ofSeconds(1));
    assertThat(guest.heard("s1")).hasSize(before).last().asString().contains("cancelled");
    assertThat(guest.ask("s2", ACLMessage.CANCEL, "(cancel)"))
        .singleElement()
        .asString()
        .startsWith("FAILURE");
  }

  /** Asks in a conversation, and keeps all that it hears there. */
  private static final class Guest extends MaestroAgent {
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
      clock.run(Duration.ofMillis(100));
      return heard(conversation);
    }

    List<String> heard(String conversation) {
      return List.copyOf(heard).stream()
          .filter(line -> line.startsWith(conversation + " "))
          .map(line -> line.substring(conversation.length() + 1))
          .toList();
    }
  }
}
