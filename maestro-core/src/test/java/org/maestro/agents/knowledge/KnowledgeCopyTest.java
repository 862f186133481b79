package org.maestro.agents.knowledge;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.agents.content.Words;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.calibration.CalibratedKnowledge;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.home.ReadingRights;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Content;
import org.maestro.sl.Expression;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** A copy of what is known says what the original does, whatever that is told. */
class KnowledgeCopyTest {
  private static final Source USHER = new Source(Source.Kind.OBSERVED, "usher");
  private static final Source BUTLER = new Source(Source.Kind.STATED, "butler");

  private final SteppedClock clock = new SteppedClock();
  private final List<Content> learnt = new ArrayList<>();
  private CollectiveKnowledge memory;
  private CollectiveKnowledge own;
  private KnowledgeCopy copy;
  private BeliefSubscriptions subscriptions;

  @BeforeEach
  void begin() throws IOException {
    Home home;
    try (InputStream turtle = getClass().getResourceAsStream("/greeters.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "greeters.ttl");
    }
    memory = new CollectiveKnowledge(home, clock);
    own = new CollectiveKnowledge(home, clock);
    copy = new KnowledgeCopy(own);
    copy.whenLearnt(learnt::add);
    subscriptions =
        new BeliefSubscriptions(
            (request, contents) -> copy.heard(Words.parse(Words.print(contents))));
    memory.watch(change -> subscriptions.changed(change, memory.snapshot()));
  }

  @AfterEach
  void end() {
    memory.close();
    own.close();
  }

  private void subscribe(ReadingRights rights) {
    subscriptions.add(new ACLMessage(ACLMessage.SUBSCRIBE), rights, memory.snapshot());
  }

  private static List<String> known(KnowledgeBase knowledge) {
    return knowledge.snapshot().beliefs().stream()
        .map(belief -> belief.fact() + " " + belief.source() + " " + belief.confidence())
        .toList();
  }

  @Test
  void saysWhatTheOriginalDoesAfterEachChange() {
    memory.state(USHER, List.of("(greeted Bob)"));
    subscribe(ReadingRights.ALL);
    assertThat(copy.hasBegun()).isTrue();
    List<Runnable> changes =
        List.of(
            () -> memory.state(USHER, List.of("(not (greeted Bob))")),
            () -> memory.state(BUTLER, List.of("(guided Bob)", "(in Bob zone-hall)")),
            () -> memory.state(USHER, List.of("(unknown (greeted Bob))")),
            () -> memory.state(BUTLER, List.of("(guided Bob)")),
            () -> memory.state(USHER, List.of("(position Bob \"1 1 0\")", "(greeted Bob)")),
            () -> memory.lost("butler"));
    for (Runnable change : changes) {
      change.run();
      assertThat(known(copy)).isEqualTo(known(memory));
      clock.runUntil(() -> false, Duration.ofSeconds(1));
    }
    assertThat(known(copy)).isNotEmpty();
  }

  @Test
  void isNotToldWhatItsReaderMayNotRead() {
    memory.state(USHER, List.of("(greeted Bob)", "(guided Bob)"));
    subscribe(new ReadingRights(Set.of("greeted"), Set.of("goals-copy")));
    memory.state(USHER, List.of("(not (greeted Bob))"));

    assertThat(known(copy)).noneMatch(fact -> fact.contains("greeted")).hasSize(1);
  }

  @Test
  void whatIsLearntHereIsKnownAtOnceAndTold() {
    subscribe(ReadingRights.ALL);
    copy.learn(
        new FeatureRun(
            "usher",
            memory.home().devices().get("usher").features().stream()
                .filter(feature -> feature.name().equals("greet"))
                .findFirst()
                .orElseThrow(),
            Map.of("person", new Term.Name("Bob"), "self", new Term.Name("usher")),
            true,
            Map.of(),
            List.of()));

    assertThat(known(copy)).anyMatch(fact -> fact.startsWith("(greeted Bob)"));
    assertThat(learnt)
        .singleElement()
        .extracting(Words::print)
        .asString()
        .contains("(:member usher) (:feature greet)", "(:person Bob)");
  }

  @Test
  void whatWasLearntOfLampsIsDoubtedHereAndThere() {
    Home home =
        new HomeLoader().load(Path.of("../scenarios/assembly/src/main/resources/homes/bob.ttl"));
    try (CollectiveKnowledge bobs = new CollectiveKnowledge(home, clock)) {
      KnowledgeCopy lit = new KnowledgeCopy(bobs);
      double stated = gain(lit);
      lit.heard(
          List.of(
              Words.content(
                  "inform",
                  Words.named("fact", Words.text("(= (gain lamp-b1 zone-b) 16)")),
                  Words.named("source", Words.text(CalibratedKnowledge.SOURCE.agent())),
                  Words.named("kind", Words.name("observed")),
                  Words.named("since", Words.text(clock.instant().toString())))));
      assertThat(gain(lit)).isEqualTo(16);

      assertThat(lit.doubt(List.of("(nextTo Cup Bob)"))).isFalse();
      assertThat(lit.doubt(List.of("(>= (illuminance zone-b) 72)"))).isTrue();
      assertThat(lit.doubt(List.of("(>= (illuminance zone-b) 72)"))).isFalse();

      assertThat(gain(lit)).isEqualTo(stated);
    }
  }

  private static double gain(KnowledgeBase knowledge) {
    return knowledge
        .snapshot()
        .number((Expression.Fluent) SlParser.expression("(gain lamp-b1 zone-b)"))
        .orElseThrow();
  }
}
