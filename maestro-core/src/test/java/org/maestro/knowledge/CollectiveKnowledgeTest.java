package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.Store;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

class CollectiveKnowledgeTest {

  private final Household home = new Household(store());

  /** Where the dataset is kept. */
  Store store() {
    return Store.IN_MEMORY;
  }

  @AfterEach
  void close() {
    home.close();
  }

  @Test
  void whatWasNeverSeenIsUnknownAndPlainFactsAreFalse() {
    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.UNKNOWN);
    assertThat(home.truth("(open rose)")).isEqualTo(Truth.FALSE);
    assertThat(home.truth("(covers cam-a zone-a)")).isEqualTo(Truth.TRUE);
    assertThat(home.truth("(covers cam-a zone-b)")).isEqualTo(Truth.FALSE);
    assertThat(home.truth("(Thing Cup)")).isEqualTo(Truth.TRUE);
    assertThat(home.truth("(>= (illuminance zone-b) 72)")).isEqualTo(Truth.UNKNOWN);
    assertThat(home.truth("(handFree rose)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void aNewValueOfAStateVariableReplacesTheOldOne() {
    home.state(Household.CAMERA, "(in Cup zone-b)");
    assertThat(home.truth("(in Cup zone-a)")).isEqualTo(Truth.FALSE);

    home.state(Household.ROBOT, "(in Cup rose)");

    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.FALSE);
    assertThat(home.truth("(handFree rose)")).isEqualTo(Truth.FALSE);
    assertThat(home.belief("(in Cup zone-b)")).map(Belief::fact).contains("(in Cup rose)");
    assertThat(home.knowledge.history("(in Cup zone-a)"))
        .extracting(Belief::fact)
        .containsExactly("(in Cup zone-b)", "(in Cup rose)");
  }

  @Test
  void exclusionsAddUpUntilTheVariableIsLost() {
    home.state(Household.CAMERA, "(not (in Bob zone-b))");
    home.state(Household.CAMERA, "(not (in Bob zone-a))");
    assertThat(home.truth("(or (in Bob zone-a) (in Bob zone-b))")).isEqualTo(Truth.FALSE);
    assertThat(home.truth("(in Bob rose)")).isEqualTo(Truth.UNKNOWN);

    home.state(Household.CAMERA, "(unknown (in Bob zone-a))");

    assertThat(home.truth("(in Bob zone-b)")).isEqualTo(Truth.UNKNOWN);
  }

  @Test
  void anExclusionOfTheValueRemovesIt() {
    home.state(Household.CAMERA, "(in Cup zone-b)");
    home.state(Household.CAMERA, "(not (in Cup zone-b))");

    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.FALSE);
    assertThat(home.truth("(in Cup zone-a)")).isEqualTo(Truth.UNKNOWN);
  }

  @Test
  void factsAgeByPredicateAndByClass() {
    home.state(Household.CAMERA, "(in Bob zone-a)", "(in Cup zone-b)", "(canSee cam-b Cup)");
    Snapshot early = home.knowledge.snapshot();
    home.pass(Duration.ofSeconds(31));

    assertThat(home.truth("(in Bob zone-a)")).isEqualTo(Truth.UNKNOWN);
    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(home.truth("(canSee cam-b Cup)")).isEqualTo(Truth.UNKNOWN);
    assertThat(early.belief((Formula.Atom) SlParser.formula("(in Bob zone-a)")))
        .as("a snapshot does not change")
        .isPresent();
    assertThat(home.knowledge.snapshot().beliefs())
        .extracting(Belief::fact)
        .containsExactly("(in Cup zone-b)");
  }

  @Test
  void whatAMemberSaysOfItselfStaysUntilItSaysItNoMore() {
    home.state(Household.ROBOT, "(in rose zone-b)", "(in Cup rose)");
    home.pass(Duration.ofMinutes(11));
    assertThat(home.truth("(in rose zone-b)")).isEqualTo(Truth.TRUE);

    home.state(Household.ROBOT, "(in rose zone-b)");

    assertThat(home.truth("(in Cup rose)")).isEqualTo(Truth.UNKNOWN);
  }

  @Test
  void placesAndNeighboursFollowFromPositions() {
    home.state(Household.CAMERA, "(position Bob \"1 0 0\")");
    home.state(Household.CAMERA, "(position Cup \"1.4 0 0\")");

    assertThat(home.truth("(and (in Cup zone-a) (nextTo Cup Bob) (nextTo Bob Cup))"))
        .isEqualTo(Truth.TRUE);
    assertThat(home.belief("(nextTo Cup Bob)"))
        .contains(new Belief("(nextTo Cup Bob)", Household.CAMERA, home.clock.instant()));

    home.state(Household.CAMERA, "(position Cup \"4 0 0\")");

    assertThat(home.truth("(nextTo Cup Bob)")).isEqualTo(Truth.FALSE);
    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void whatIsCarriedHasNoPositionOfItsOwn() {
    home.state(Household.CAMERA, "(position Bob \"4.1 0 0\")");
    home.state(Household.CAMERA, "(position Cup \"4 0 0\")");

    home.state(Household.ROBOT, "(in rose zone-b)", "(in Cup rose)");

    assertThat(home.knowledge.snapshot().value("position", List.of(new Term.Name("Cup"))))
        .isEmpty();
    assertThat(home.truth("(nextTo Cup Bob)")).isEqualTo(Truth.UNKNOWN);
    assertThat(home.truth("(in Bob zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(home.truth("(in Cup rose)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void ofOneInstantAnObservationStandsAgainstAnExpectation() {
    home.state(Household.CAMERA, "(in Cup zone-b)");
    home.state(new Source(Source.Kind.EXPECTED, "rose"), "(in Cup rose)");
    assertThat(home.truth("(in Cup zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(home.knowledge.history("(in Cup rose)"))
        .extracting(Belief::fact)
        .containsExactly("(in Cup zone-b)", "(in Cup rose)");

    home.pass(Duration.ofMillis(1));
    home.state(new Source(Source.Kind.EXPECTED, "rose"), "(in Cup rose)");

    assertThat(home.truth("(in Cup rose)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void aLostMemberTakesWithItWhatItSaidOfItselfAndWhatItCarried() {
    home.state(Household.ROBOT, "(in rose zone-b)", "(in Cup rose)", "(open rose)");
    home.state(Household.CAMERA, "(in Bob zone-b)");

    home.knowledge.lost("rose");

    assertThat(home.truth("(in rose zone-b)")).isEqualTo(Truth.UNKNOWN);
    assertThat(home.truth("(in Cup rose)")).isEqualTo(Truth.UNKNOWN);
    assertThat(home.truth("(open rose)")).isEqualTo(Truth.FALSE);
    assertThat(home.truth("(in Bob zone-b)")).isEqualTo(Truth.TRUE);
  }

  @Test
  void eachWriteIsToldOnceAndRepetitionIsNoNews() {
    List<KnowledgeBase.Change> changes = new ArrayList<>();
    home.knowledge.watch(changes::add);
    home.state(Household.ROBOT, "(in rose zone-b)", "(= (level rose) 0.5)");
    home.state(Household.ROBOT, "(in rose zone-b)", "(= (level rose) 0.5)");
    home.knowledge.lost("rose");

    assertThat(changes)
        .extracting(KnowledgeBase.Change::facts)
        .containsExactly(
            List.of("(in rose zone-b)", "(= (level rose) 0.5)"),
            List.of("(lost rose)", "(unknown (in rose zone-b))", "(unknown (level rose))"));
    assertThat(home.knowledge.snapshot().version()).isEqualTo(2);
  }

  @Test
  void theDatasetTellsWhoSaidACurrentFactAndWhen() {
    home.state(Household.CAMERA, "(in Cup zone-b)");
    home.state(Household.ROBOT, "(in Cup rose)");

    List<Map<String, String>> rows =
        home.knowledge.select(
            """
            PREFIX maestro: <https://w3id.org/maestro#>
            PREFIX prov: <http://www.w3.org/ns/prov#>
            PREFIX g: <https://example.org/home#graph/>
            SELECT ?place ?who WHERE {
              GRAPH g:world { <https://example.org/home#Cup> <https://example.org/words#in> ?place .
                              ?observation maestro:fact ?fact }
              GRAPH g:observations { ?observation prov:wasAttributedTo ?who } }
            """);

    assertThat(rows)
        .containsExactly(
            Map.of(
                "place", "https://example.org/home#rose", "who", "https://example.org/home#rose"));
    assertThat(
            home.knowledge.select(
                "SELECT ?o WHERE { GRAPH <https://example.org/home#graph/observations>"
                    + " { ?o a <http://www.w3.org/ns/sosa/Observation> } }"))
        .hasSize(2);
  }

  @Test
  void aDeviceThatJoinsIsAmongTheIndividuals() {
    home.knowledge.describe(
        Household.device(Household.individual("cam-c", "Device", "covers", "zone-a")));

    assertThat(home.truth("(covers cam-c zone-a)")).isEqualTo(Truth.TRUE);
    assertThat(home.knowledge.home().devices()).containsKey("cam-c");
  }

  @Test
  void questionsBindVariablesToIndividualsAndValues() {
    home.state(Household.CAMERA, "(position Cup \"4 0 0\")");
    Question question = new Question(home.knowledge.snapshot());

    assertThat(question.queryRef(SlParser.formula("(in Cup ?where)")))
        .containsExactly(Map.of("where", new Term.Name("zone-b")));
    assertThat(question.queryRef(SlParser.formula("(position ?x ?p)")))
        .containsExactly(Map.of("x", new Term.Name("Cup"), "p", new Term.Text("4 0 0")));
    assertThat(question.queryIf(SlParser.formula("(in Bob ?where)"))).isEqualTo(Truth.UNKNOWN);
  }

  @Test
  void whatIsNoFactIsRefusedWithOneSentence() {
    assertThatThrownBy(() -> home.state(Household.ROBOT, "(in rose"))
        .isInstanceOf(KnowledgeException.class)
        .hasMessageContaining("The fact (in rose by rose is not MAESTRO-SL.");
    assertThatThrownBy(() -> home.state(Household.ROBOT, "(in ?x zone-a)"))
        .hasMessageContaining("has variables");
    assertThat(home.knowledge.snapshot().version()).isZero();
  }

  @Test
  void aPositionIsNoLongerGoodThanThePlaceItTells() {
    home.state(Household.CAMERA, "(position Bob \"1 0 0\")");
    home.pass(Duration.ofSeconds(31));
    home.state(Household.CAMERA, "(position Cup \"1.2 0 0\")");

    assertThat(home.truth("(in Bob zone-a)")).isEqualTo(Truth.UNKNOWN);
    assertThat(home.truth("(nextTo Cup Bob)")).isEqualTo(Truth.UNKNOWN);
  }

  @Test
  void writersOnManyThreadsLeaveOneConsistentWorld() throws InterruptedException {
    List<Long> versions = new ArrayList<>();
    home.knowledge.watch(change -> versions.add(change.version()));
    List<Thread> writers = new ArrayList<>();
    for (int writer = 0; writer < 4; writer++) {
      String agent = "writer-" + writer;
      Thread thread =
          new Thread(
              () -> {
                for (int i = 0; i < 50; i++) {
                  String place = i % 2 == 0 ? "zone-a" : "zone-b";
                  home.state(
                      new Source(Source.Kind.OBSERVED, agent),
                      "(in Cup " + place + ")",
                      "(= (level " + agent + ") " + i + ")");
                }
              });
      writers.add(thread);
      thread.start();
    }
    for (Thread writer : writers) {
      writer.join();
    }

    assertThat(versions).isSorted().doesNotHaveDuplicates().hasSize(200);
    assertThat(home.knowledge.snapshot().beliefs()).hasSize(5);
    assertThat(
            home.knowledge.select(
                "SELECT ?s WHERE { GRAPH <https://example.org/home#graph/world>"
                    + " { ?s <https://w3id.org/maestro#fact> ?f } }"))
        .as("one pointer for each current fact")
        .hasSize(5);
  }
}
