package org.maestro.agents.knowledge;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.KnowledgeAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.BareJade;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.SlParser;

/**
 * What agents elsewhere read of the collective knowledge (Three-layered architecture, 2; M12):
 * right, quick, and bounded.
 */
class KnowledgeCacheTest {
  private static final Source CAMERA = new Source(Source.Kind.OBSERVED, "cam-b");
  private static final int MOST = 8;

  @TempDir static Path files;
  private static SteppedClock clock;
  private static CollectiveKnowledge knowledge;
  private static BareJade jade;
  private static Reader reader;

  @BeforeAll
  static void start() {
    clock = new SteppedClock();
    Home home =
        new HomeLoader().load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"));
    knowledge = new CollectiveKnowledge(home, clock);
    jade = new BareJade("reading", files);
    AgentTime time = AgentTime.of(clock);
    BareJade.start(
        jade.main(),
        AgentNames.KNOWLEDGE,
        new KnowledgeAgent(
            jade.birth(), time, knowledge, (text, member) -> home.devices().get(member)));
    reader = new Reader(jade.birth(), time);
    BareJade.start(jade.join("elsewhere"), "reader", reader);
  }

  @AfterAll
  static void end() {
    jade.close();
    knowledge.close();
  }

  @Test
  void whatWasReadOnceIsAnsweredWithoutAWordAndStaysRight() {
    knowledge.state(CAMERA, List.of("(in Bob zone-b)"));
    assertThat(read("(in Bob ?where)")).singleElement().asString().contains("(:where zone-b)");
    knowledge.state(CAMERA, List.of("(in Bob zone-a)"));
    clock.run(Duration.ofSeconds(1));

    List<String> heard = new ArrayList<>();
    boolean[] atOnce = {false};
    reader.now(
        cache -> {
          cache.read(SlParser.formula("(in Bob ?where)"), known -> heard.addAll(words(known)));
          atOnce[0] = !heard.isEmpty();
        });
    assertThat(atOnce[0]).as("without a message").isTrue();
    assertThat(heard).singleElement().asString().contains("(:where zone-a)");
    clock.run(Duration.ofMinutes(1));
    assertThat(read("(in Bob ?where)")).singleElement().asString().contains("(:truth unknown)");
  }

  @Test
  void whoFollowsIsToldEachChange() {
    List<String> heard = Collections.synchronizedList(new ArrayList<>());
    reader.now(
        cache ->
            cache.follow(
                SlParser.formula("(in rose zone-b)"), known -> heard.addAll(words(known))));
    clock.run(Duration.ofSeconds(1));
    knowledge.state(CAMERA, List.of("(in rose zone-b)"));
    clock.run(Duration.ofSeconds(1));
    knowledge.state(CAMERA, List.of("(in rose zone-a)"));
    clock.run(Duration.ofSeconds(1));
    assertThat(heard).hasSize(3);
    assertThat(heard.get(1)).contains("(:truth true)");
    assertThat(heard.get(2)).contains("(:truth false)");
  }

  @Test
  void ofManyQuestionsOnlyTheLatestAreKeptAndTheOthersSubscriptionsEnd() {
    for (int number = 0; number < 5 * MOST; number++) {
      read("(<= (illuminance zone-a) %d)".formatted(number));
    }
    reader.now(cache -> assertThat(cache.size()).isEqualTo(MOST));
    assertThat(reader.openConversations()).isEqualTo(MOST);
    assertThat(read("(<= (illuminance zone-a) 1)")).hasSize(1);
    assertThat(reader.openConversations()).isEqualTo(MOST);
  }

  private static List<String> read(String question) {
    List<String> heard = Collections.synchronizedList(new ArrayList<>());
    reader.now(
        cache -> cache.read(SlParser.formula(question), known -> heard.addAll(words(known))));
    clock.run(Duration.ofMillis(100));
    return List.copyOf(heard);
  }

  private static List<String> words(KnowledgeCache.Known known) {
    assertThat(known.failure()).isEmpty();
    return known.answers().stream().map(Words::print).toList();
  }

  /** Reads through a cache. */
  private static final class Reader extends MaestroAgent {
    private static final long serialVersionUID = 1L;
    private final transient KnowledgeCache cache = new KnowledgeCache(this, MOST);

    Reader(Birth birth, AgentTime time) {
      super(birth, time);
    }

    @Override
    protected void received(ACLMessage message) {
      throw new AssertionError("Nobody asks the reader: " + message);
    }

    void now(Consumer<KnowledgeCache> work) {
      tell(() -> work.accept(cache));
      clock.run(Duration.ofMillis(10));
    }

    int openConversations() {
      return conversations().openCount();
    }
  }
}
