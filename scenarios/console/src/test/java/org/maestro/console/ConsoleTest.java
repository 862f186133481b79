package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.console.api.Api;
import org.maestro.console.client.HttpQuestions;
import org.maestro.console.client.UnreachableConsoleException;
import org.maestro.console.questions.AgentOrder;
import org.maestro.console.questions.RefusalException;

/** The API of a running platform: what it answers, what it refuses, and what it tells. */
@Isolated("its time is wall time, which others beside it would take")
class ConsoleTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static ServedHome home;

  @BeforeAll
  static void start() {
    home = ServedHome.start();
  }

  @AfterAll
  static void end() {
    home.close();
  }

  @ParameterizedTest
  @CsvSource({
    "/platform, platform",
    "/home, home",
    "/facts, facts",
    "/goals, goals",
    "/agents, agents",
    "/containers, agents-containers",
    "/words, words",
    "/knowledge?question=(in%20rose%20%3Fwhere), know"
  })
  void whatIsAskedIsAnsweredAsTheDocumentSays(String path, String schema) throws Exception {
    ServedHome.Answer answer = home.get(path);

    assertThat(answer.status()).isEqualTo(200);
    assertThat(answer.document().isEmpty()).isFalse();
    assertValid(answer.document(), schema);
  }

  @Test
  void aGoalIsStatedAndFollowedAndToldInFull() throws Exception {
    ServedHome.Answer accepted = home.post("/goals", "{\"goal\": \"(canSee ?who Bob)\"}");
    assertThat(accepted.status()).isEqualTo(201);
    assertValid(accepted.document(), "goal-accepted");
    String id = accepted.document().path("id").asText();

    await(() -> state(id).equals("achieved"));

    JsonNode story = home.get("/goals/" + id + "/story").document();
    assertValid(story, "why");
    assertThat(story.path("story").findValuesAsText("kind")).startsWith("goal").endsWith("end");
    JsonNode choice = home.get("/goals/" + id + "/story?step=1").document();
    assertThat(choice.at("/story/0/text").asText()).isNotEmpty();
  }

  @Test
  void aPlanIsShownBeforeItIsBegun() throws Exception {
    ServedHome.Answer lit =
        home.post("/previews", "{\"goal\": \"(keep (>= (illuminance zone-b) 72))\"}");
    assertThat(lit.status()).as(lit.toString()).isEqualTo(200);
    assertValid(lit.document(), "preview");
    assertThat(lit.document().path("verdict").asText()).isEqualTo("plan");
    int goals = home.get("/goals").document().path("goals").size();

    ServedHome.Answer cup = home.post("/previews", "{\"goal\": \"(in rose zone-a)\"}");
    assertValid(cup.document(), "preview");
    assertThat(cup.document().path("cost").asDouble()).isPositive();
    assertThat(cup.document().at("/steps/0/text").asText()).isEqualTo("rose drives to zone-a");
    ServedHome.Answer never =
        home.post("/previews", "{\"goal\": \"(>= (illuminance zone-b) 100000)\"}");
    assertValid(never.document(), "preview");
    assertThat(never.document().path("verdict").asText()).isEqualTo("none");
    assertThat(home.post("/previews", "{\"goal\": \"(flies Bob)\"}").problem()).contains("flies");
    assertThat(home.post("/previews", "{\"goal\": \"(after 5 (in rose zone-a))\"}").problem())
        .contains("has no plan before it begins");
    assertThat(home.get("/goals").document().path("goals")).as("nothing is begun").hasSize(goals);
  }

  @Test
  void aGoalIsWeighed() throws Exception {
    ServedHome.Answer stated =
        home.post(
            "/goals",
            "{\"goal\": \"(keep (>= (illuminance zone-a) 10))\", \"benefit\": \"(* 2 30)\","
                + " \"chance\": 0.5, \"allowed_s\": 600}");
    String id = stated.document().path("id").asText();
    await(() -> state(id).equals("holding"));

    JsonNode goals = home.get("/goals").document();
    assertValid(goals, "goals");
    JsonNode worth = row(goals, id).path("worth");
    assertThat(worth.path("benefit").asDouble()).isEqualTo(60);
    assertThat(worth.path("utility").asDouble())
        .isCloseTo(
            worth.path("chance").asDouble() * 60 - worth.path("cost").asDouble(), within(1e-6));
    assertThat(worth.path("weight").asDouble())
        .isCloseTo(
            worth.path("utility").asDouble() * worth.path("urgency").asDouble(), within(1e-6));
    home.delete("/goals/" + id);
    await(() -> state(id).equals("cancelled"));
    assertThat(row(home.get("/goals").document(), id).path("worth").isNull()).isTrue();
  }

  private static JsonNode row(JsonNode goals, String id) {
    for (JsonNode row : goals.path("goals")) {
      if (row.path("id").asText().equals(id)) {
        return row;
      }
    }
    throw new AssertionError("there is no " + id);
  }

  @Test
  void aGoalIsGivenUp() throws Exception {
    String id = home.state("(keep (>= (illuminance zone-a) 10))");
    await(() -> state(id).equals("holding"));

    assertThat(home.delete("/goals/" + id).status()).isEqualTo(204);

    await(() -> state(id).equals("cancelled"));
    assertThat(home.delete("/goals/" + id).problem()).contains(id);
  }

  @Test
  void anAgentIsMovedConfiguredRemovedAndAdded() throws Exception {
    HttpQuestions questions = new HttpQuestions(home.uri());
    String lamp =
        """
        @prefix maestro: <https://w3id.org/maestro#> .
        @prefix : <https://w3id.org/maestro/domain#> .
        <#lamp-b1> a :Lamp ; maestro:pose "4.1 1.5 2.8" ;
          maestro:luminousIntensity 505 ; maestro:beamAngle 100 ; :power 7 .
        """;

    for (AgentOrder order :
        List.of(
            new AgentOrder.Move("lamp-b1", "sensors"),
            new AgentOrder.Reconfigure("lamp-b1", lamp, "lamp.ttl"),
            new AgentOrder.Remove("lamp-b1"),
            new AgentOrder.Add(lamp, "lamp.ttl", Optional.empty(), Optional.empty(), List.of()))) {
      JsonNode told = questions.order(order).join();
      assertValid(told, "told");
      assertThat(told.path("told").path(0).asText()).as(order.toString()).contains("lamp-b1");
    }
    assertThatThrownBy(() -> questions.order(new AgentOrder.Remove("lamp-z")).join())
        .hasCauseInstanceOf(RefusalException.class)
        .hasMessageContaining("lamp-z");
    ServedHome.Answer faulty = home.post("/agents", "{\"description\": \"x\", \"needs\": [1]}");
    assertThat(faulty.problem()).isEqualTo("The member needs is a list of texts.");
  }

  @Test
  void allDevicesAreMadeSafe() throws Exception {
    assertThat(home.post("/safe-state", "").status()).isEqualTo(204);
    await(
        () ->
            home.get("/agents").document().path("agents").findValuesAsText("state").stream()
                .anyMatch("safe"::equals));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{}                                  | The member goal is missing.",
        "[]                                  | has to be an object with goal, priority, deadline_s, benefit,",
        "{\"gaol\": \"x\"}                   | There is no member gaol here",
        "{\"goal\": 7}                       | The member goal is a text.",
        "{\"goal\": null}                    | The member goal is a text.",
        "{\"goal\": \"x\", \"priority\": 1.5} | The member priority is a whole number.",
        "{\"goal\": \"x\", \"priority\": 1e99} | The member priority is a whole number.",
        "{\"goal\": \"x\", \"deadline_s\": \"soon\"} | The member deadline_s is a number or null.",
        "{\"goal\": \"(canSee ?who Bob)\", \"benefit\": \"(+ 4\"} | The benefit is no number",
        "{\"goal\": \"(canSee ?who Bob)\", \"benefit\": true} | The member benefit is",
        "{\"goal\": \"(canSee ?who Bob)\", \"benefit\": 6, \"chance\": 2} | is not from 0 to 1",
        "{\"goal\": \"(canSee\"}             | was expected, but found the end of the text.",
        "{\"goal\": \"(canSe ?who Bob)\"}    | write canSee, if that is meant",
        "{\"goal\": \"(canSee ?who Bob)\"    | is no JSON document",
        "{\"goal\": \"a\", \"goal\": \"b\"}  | is no JSON document",
        "{} {}                               | is no JSON document"
      })
  void whatIsWrongIsASentence(String body, String sentence) throws Exception {
    ServedHome.Answer answer = home.post("/goals", body);

    assertThat(answer.status()).as(answer.toString()).isEqualTo(400);
    assertValid(answer.document(), "problem");
    assertThat(answer.problem()).contains(sentence);
    assertThat(answer.document().path("kind").asText()).isEqualTo("bad-input");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "/nothing               | 404 | There is nothing at /api/v1/nothing",
        "/goals/G99999/story    | 400 | There is no goal G99999",
        "/goals/%22%29/story    | 400 | goal",
        "/goals/G1/story?step=x | 400 | step is a whole number, not \"x\".",
        "/goals/G1/story?plan=1 | 400 | add step",
        "/goals?page=2          | 400 | There is no parameter page here",
        "/knowledge             | 400 | The parameter question is missing.",
        "/knowledge?question=(  | 400 | question",
        "/knowledge?question=(flies%20Bob) | 400 | flies"
      })
  void whatIsNotThereIsASentence(String path, int status, String sentence) throws Exception {
    ServedHome.Answer answer = home.get(path);

    assertThat(answer.status()).as(answer.toString()).isEqualTo(status);
    assertValid(answer.document(), "problem");
    if (!sentence.equals("goal") && !sentence.equals("question")) {
      assertThat(answer.problem()).contains(sentence);
    }
  }

  @Test
  void aFormOfAnotherSiteIsNoRequest() throws Exception {
    ServedHome.Answer answer =
        home.send(
            home.to("/goals")
                .header("Content-Type", "text/plain")
                .POST(HttpRequest.BodyPublishers.ofString("{\"goal\": \"(canSee ?who Bob)\"}")));
    assertThat(answer.status()).isEqualTo(400);
    assertThat(answer.problem()).contains("Content-Type application/json");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Host: home.example.org",
        "Host: 127.0.0.1.example.org",
        "Host: 127.0.0.1\r\nOrigin: http://example.org",
        "Host: 127.0.0.1\r\nOrigin: null",
        "Host: localhost\r\nSec-Fetch-Site: cross-site",
        "Host: localhost\r\nSec-Fetch-Site: same-site"
      })
  void pagesOfOthersAskNothing(String headers) throws IOException {
    for (String request : List.of("GET /api/v1/goals", "POST /api/v1/safe-state", "GET /")) {
      assertThat(raw(request, headers)).startsWith("HTTP/1.1 403 ").contains("\"kind\":");
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "Host: 127.0.0.1",
        "Host: localhost",
        "Host: [::1]",
        "Host: LOCALHOST\r\nOrigin: http://LOCALHOST",
        "Host: localhost\r\nSec-Fetch-Site: same-origin"
      })
  void ourOwnPageDoes(String headers) throws IOException {
    assertThat(raw("GET /api/v1/goals", headers)).startsWith("HTTP/1.1 200 ");
  }

  @Test
  void thePageIsOfOurFilesAlone() throws IOException {
    String page = raw("GET /", "Host: localhost");

    assertThat(page)
        .startsWith("HTTP/1.1 200 ")
        .contains("Content-Security-Policy: default-src 'none'; script-src 'self'")
        .contains("<script type=\"module\" src=\"app.js\">")
        .doesNotContain("http://www")
        .doesNotContain("Server: ");
    assertThat(raw("GET /app.js", "Host: localhost")).contains("/javascript");
    assertThat(raw("GET /../Console.class", "Host: localhost")).doesNotStartWith("HTTP/1.1 200 ");
  }

  @Test
  void whoListensHearsAllThatIsSoAndThenWhatHappens() throws Exception {
    HttpResponse<InputStream> response =
        home.stream(home.to("/events").header("Accept", "text/event-stream").build());
    List<String> heard = new ArrayList<>();
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(response.body(), StandardCharsets.UTF_8))) {
      String id = "";
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        if (line.startsWith("event: ")) {
          heard.add(line.substring("event: ".length()));
        }
        if (id.isEmpty() && heard.containsAll(List.of("home", "facts", "goals", "agents"))) {
          id = home.state("(canSee ?who Cup)");
        }
        if (line.contains("\"goal\":\"" + id + "\"") && line.contains("\"kind\":\"end\"")) {
          break;
        }
      }
    }
    assertThat(heard.subList(0, 2)).containsExactly("home", "facts");
    assertThat(heard).contains("story").filteredOn("facts"::equals).hasSizeGreaterThan(1);
  }

  /** Nobody tells that a fact has grown too old; what was seen is not shown as seen for ever. */
  @Test
  @Timeout(60)
  void whatGrowsTooOldIsToldToBeGone() throws Exception {
    HttpResponse<InputStream> response =
        home.stream(home.to("/events").header("Accept", "text/event-stream").build());
    Set<String> seen = new HashSet<>();
    boolean gone = false;
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(response.body(), StandardCharsets.UTF_8))) {
      for (String line = lines.readLine(); line != null && !gone; line = lines.readLine()) {
        if (line.startsWith("event: home")) {
          home.state("(canSee ?who Bob)");
        } else if (line.startsWith("data: {\"all\"")) {
          JsonNode news = new ObjectMapper().readTree(line.substring("data: ".length()));
          news.path("facts").findValuesAsText("fact").stream()
              .filter(fact -> fact.matches("\\(canSee \\S+ Bob\\)"))
              .forEach(seen::add);
          for (JsonNode fact : news.path("gone")) {
            gone |= seen.contains(fact.asText());
          }
        }
      }
    }
    assertThat(gone).isTrue();
  }

  @Test
  void whatIsTooLongIsNotRead() throws Exception {
    ServedHome.Answer answer = home.post("/goals", "{\"goal\": \"" + "x".repeat(1_100_000) + "\"}");
    assertThat(answer.status()).isEqualTo(413);
    assertValid(answer.document(), "problem");
  }

  @Test
  void whatIsNotDoneSoIsSaid() throws Exception {
    ServedHome.Answer answer = home.delete("/goals");
    assertThat(answer.status()).isEqualTo(405);
    assertValid(answer.document(), "problem");
    assertThat(answer.problem()).startsWith("DELETE is not done with /api/v1/goals;");
    assertThat(raw("DELETE /api/v1/goals", "Host: localhost")).contains("Allow: GET, POST\r\n");
    assertThat(raw("PUT /api/v1/goals/G1", "Host: localhost")).contains("Allow: DELETE\r\n");
  }

  /** Programs that ask for events with their tools' own headers would else get nothing at all. */
  @Test
  void whoListensSaysSo() throws Exception {
    ServedHome.Answer answer = home.get("/events");
    assertThat(answer.status()).isEqualTo(406);
    assertValid(answer.document(), "problem");
    assertThat(answer.problem()).endsWith("ask with the header Accept: text/event-stream.");
  }

  @Test
  void aPortThatIsTakenIsASentence() throws IOException {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      assertThatThrownBy(
              () ->
                  Console.start(
                      home.site().platform(),
                      home.site().observer(),
                      "second",
                      Serving.onLoopback(taken.getLocalPort()),
                      Optional.empty(),
                      Optional.empty(),
                      "1"))
          .isInstanceOf(RefusalException.class)
          .hasMessageContaining("cannot listen on port " + taken.getLocalPort());
    }
  }

  /** Commands ask so. */
  @Test
  void programsAskInWordsOfTheirOwn() throws Exception {
    HttpQuestions questions = new HttpQuestions(home.uri());
    String id = home.state("(canSee ?who Bob)");

    assertThat(questions.goals().join().path("goals").findValuesAsText("id")).contains(id);
    assertThat(questions.know("(in rose ?where)").join().at("/answers/0/truth").asText())
        .isEqualTo("true");
    assertThat(questions.agents().join().path("agents").findValuesAsText("agent"))
        .contains("rose", "CCA");
    assertThat(questions.containers().join().path("containers").findValuesAsText("container"))
        .contains("Main-Container");
    assertThat(questions.words().join().path("words").findValuesAsText("word")).contains("canSee");
    await(() -> state(id).equals("achieved"));
    assertThat(
            questions
                .story(id, OptionalInt.empty(), OptionalInt.of(1))
                .join()
                .path("goal")
                .asText())
        .isEqualTo(id);
    questions.stop(Optional.empty()).join();
    assertThatThrownBy(() -> questions.cancel("G99999").join())
        .hasCauseInstanceOf(RefusalException.class)
        .hasMessageContaining("There is no goal G99999");
  }

  @Test
  void whereNoConsoleAnswersThatIsSaid() throws IOException {
    int free;
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName("127.0.0.1"))) {
      free = socket.getLocalPort();
    }
    HttpQuestions questions = new HttpQuestions(URI.create("http://127.0.0.1:" + free));
    assertThatThrownBy(questions::goals).isInstanceOf(UnreachableConsoleException.class);
  }

  private static String state(String goal) throws Exception {
    for (JsonNode row : home.get("/goals").document().path("goals")) {
      if (row.path("id").asText().equals(goal)) {
        return row.path("state").asText();
      }
    }
    return "";
  }

  private interface Condition {
    boolean holds() throws Exception;
  }

  private static void await(Condition condition) {
    Awaitility.await().atMost(LIMIT).until(condition::holds);
  }

  private static void assertValid(JsonNode document, String name) throws Exception {
    home.assertValid(document, name);
  }

  /** With headers that clients of Java do not send. */
  private static String raw(String request, String headers) throws IOException {
    try (Socket socket = new Socket(InetAddress.getByName("127.0.0.1"), home.uri().getPort())) {
      socket
          .getOutputStream()
          .write(
              (request
                      + " HTTP/1.1\r\n"
                      + headers
                      + "\r\nContent-Length: 0\r\nConnection: close\r\n\r\n")
                  .getBytes(StandardCharsets.ISO_8859_1));
      return new String(socket.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  @Test
  void eachOperationIsInTheDocument() throws Exception {
    JsonNode document = home.get("/openapi.json").document();

    assertThat(document.at("/info/version").asText()).isEqualTo("1.2.3");
    assertThat(document.at("/servers/0/url").asText()).isEqualTo(Api.ROOT);
    List<String> paths = new ArrayList<>();
    document.path("paths").fieldNames().forEachRemaining(paths::add);
    assertThat(paths)
        .contains("/goals", "/goals/{goal}", "/goals/{goal}/story", "/events", "/safe-state");
    assertThat(document.at("/paths/~1events/get/responses/406/description").asText())
        .contains("text/event-stream");
    assertThat(document.findValuesAsText("operationId")).doesNotHaveDuplicates();
    for (String referred : document.findValuesAsText("$ref")) {
      assertThat(document.at(referred.substring(1)).isMissingNode()).as(referred).isFalse();
    }
  }
}
