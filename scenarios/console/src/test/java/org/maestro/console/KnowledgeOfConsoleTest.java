package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.console.ServedHome.Answer;
import org.maestro.knowledge.api.Source;

/** What is known, asked in SPARQL, and who said what of it. */
class KnowledgeOfConsoleTest {
  private static ServedHome home;

  @BeforeAll
  static void start() {
    home = ServedHome.start();
    state("cam-a", "(in Cup zone-a)");
    state("cam-b", "(in Cup zone-b)");
  }

  @AfterAll
  static void stop() {
    home.close();
  }

  private static void state(String camera, String fact) {
    home.site()
        .platform()
        .knowledge()
        .state(new Source(Source.Kind.OBSERVED, camera), List.of(fact));
  }

  private static Answer history(String fact) throws Exception {
    return home.get("/knowledge/history?fact=" + URLEncoder.encode(fact, StandardCharsets.UTF_8));
  }

  private static Answer query(String sparql) throws Exception {
    return home.post(
        "/queries", new ObjectMapper().createObjectNode().put("query", sparql).toString());
  }

  @Test
  void whoSaidWhatIsToldWithWhatCountsNow() throws Exception {
    JsonNode claims = history("(in Cup zone-a)").document().path("claims");

    assertThat(claims)
        .extracting(claim -> claim.path("source").asText())
        .contains("cam-a", "cam-b");
    assertThat(claims)
        .filteredOn(claim -> claim.path("counts").asBoolean())
        .extracting(claim -> claim.path("fact").asText())
        .containsExactly("(in Cup zone-b)");
  }

  @Test
  void whatHasNoHistoryIsNoFault() throws Exception {
    assertThat(history("(in Book zone-a)").document().path("claims")).isEmpty();
    assertThat(history("(illuminance zone-b)").status()).isEqualTo(200);
    assertThat(history("(in Cup").problem()).contains("\")\"");
  }

  @Test
  void aQueryFindsWhatIsKnown() throws Exception {
    JsonNode document =
        query(
                """
                PREFIX maestro: <https://w3id.org/maestro#>
                SELECT ?fact ?who WHERE { GRAPH ?g { ?o maestro:sourceName ?who . OPTIONAL { ?o maestro:fact ?fact } } }
                """)
            .document();

    assertThat(document.path("variables"))
        .extracting(JsonNode::asText)
        .containsExactly("fact", "who");
    assertThat(document.path("rows")).extracting(row -> row.path("who").asText()).contains("cam-b");
    assertThat(document.path("whole").asBoolean()).isTrue();
  }

  @Test
  void aQueryReadsAndAsksNobodyElse() throws Exception {
    assertThat(query("SELECT ?x WHERE {").problem()).contains("The query is not SPARQL");
    assertThat(query("DELETE WHERE { ?a ?b ?c }").problem()).contains("The query is not SPARQL");
    assertThat(query("ASK {}").problem()).contains("Only SELECT is answered");
    assertThat(query("SELECT ?x WHERE { SERVICE <http://127.0.0.1:1/> { ?x ?y ?z } }").problem())
        .contains("SERVICE would have the platform ask another one");
    assertThat(
            query(
                    "SELECT ?x WHERE { { SELECT ?x { SERVICE <http://127.0.0.1:1/> { ?x ?y ?z } } } }")
                .problem())
        .contains("SERVICE would have the platform ask another one");
    assertThat(query("PREFIX f: <java:java.lang.> SELECT (f:Runtime() AS ?x) WHERE {}").problem())
        .contains("Functions of Java are not called");
  }

  @Test
  void aQueryEndsThoughThereIsMuch() throws Exception {
    JsonNode many =
        query("SELECT * WHERE { GRAPH ?g { ?a ?b ?c } GRAPH ?h { ?d ?e ?f } }").document();

    assertThat(many.path("rows")).hasSize(1_000);
    assertThat(many.path("whole").asBoolean()).isFalse();
  }

  @Test
  @Tag("full")
  void aQueryThatTakesTooLongIsGivenUp() throws Exception {
    assertThat(
            query(
                    "SELECT (COUNT(*) AS ?n) WHERE { GRAPH ?g { ?a ?b ?c } GRAPH ?h { ?d ?e ?f } GRAPH ?i { ?j ?k ?l } }")
                .problem())
        .contains("The query takes longer than 10 s; ask for less.");
  }
}
