package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.net.URI;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.apache.jena.fuseki.main.FusekiServer;
import org.apache.jena.sparql.core.DatasetGraph;
import org.apache.jena.sparql.core.DatasetGraphFactory;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.Store;

/** All that is asked of the collective knowledge, with its dataset behind a SPARQL endpoint. */
class KnowledgeAtAnEndpointTest {
  private static final int DATASETS = 200;
  private static final AtomicInteger USED = new AtomicInteger();
  private static FusekiServer server;

  @BeforeAll
  static void start() {
    FusekiServer.Builder builder = FusekiServer.create().port(0).loopback(true);
    for (int number = 0; number < DATASETS; number++) {
      DatasetGraph empty = DatasetGraphFactory.createTxnMem();
      builder.add("/home" + number, empty);
    }
    server = builder.build().start();
  }

  @AfterAll
  static void stop() {
    server.stop();
  }

  private static Store fresh() {
    return Store.parse(
        "http://localhost:%d/home%d".formatted(server.getPort(), USED.getAndIncrement()));
  }

  @Test
  void whatWasSaidIsRememberedAfterARestartAndNotBelieved() {
    LastingStore.rememberOverARestart(fresh());
  }

  /** Names come from messages: none may end its IRI and begin an update of its own. */
  @Test
  void whatSourcesCallThemselvesIsNoUpdate() {
    Household home = new Household(fresh());
    String name = "a> } } ; CLEAR ALL ; INSERT DATA { <x> <y> \"z\" } # \\ \u0007 ";
    home.state(new Source(Source.Kind.STATED, name), "(in Cup zone-a)", "(in Bob zone-b)");
    List<Map<String, String>> sources =
        home.knowledge.select(
            "SELECT ?n WHERE { GRAPH ?g { ?o <https://w3id.org/maestro#sourceName> ?n } }");
    assertThat(sources).hasSize(2).allSatisfy(row -> assertThat(row).containsEntry("n", name));
    assertThat(home.knowledge.select("SELECT ?x WHERE { ?x ?y \"z\" }")).isEmpty();
    home.close();
  }

  @Test
  void anEndpointThatIsNotThereIsToldInOneSentence() {
    assertThatThrownBy(
            () ->
                new Household(
                    new Store.Endpoint(
                        URI.create("http://localhost:1/none"),
                        URI.create("http://localhost:1/none"))))
        .isInstanceOf(KnowledgeException.class)
        .hasMessageContaining(
            "No SPARQL endpoint answers at http://localhost:1/none (nothing listens there)")
        .message()
        .doesNotContain("\n");
    assertThatThrownBy(() -> Store.parse("http://:80")).hasMessageContaining("is no address");
    assertThat(Store.parse("http://a/query,http://a/update"))
        .isEqualTo(new Store.Endpoint(URI.create("http://a/query"), URI.create("http://a/update")));
  }

  @Nested
  class Statements extends CollectiveKnowledgeTest {
    @Override
    Store store() {
      return fresh();
    }
  }

  @Nested
  class Disagreement extends DisagreementTest {
    @Override
    Store store() {
      return fresh();
    }
  }

  @Nested
  class Learning extends LearningTest {
    @Override
    Store store() {
      return fresh();
    }
  }

  @Nested
  class Past extends HistoryTest {
    @Override
    Store store() {
      return fresh();
    }
  }

  @Nested
  class BobsHome extends BobsHomeKnowledgeTest {
    @Override
    Store store() {
      return fresh();
    }
  }
}
