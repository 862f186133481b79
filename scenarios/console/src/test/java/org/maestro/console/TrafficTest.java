package org.maestro.console;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.BufferedReader;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.net.http.HttpResponse;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/**
 * What goes over the bus and between agents, as the API tells it and the page draws it
 * (Three-layered architecture, 3.3.2; M73).
 */
@Isolated("its time is wall time, which others beside it would take")
class TrafficTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final String WRONG =
      "{\"v\": \"1.3\", \"id\": \"w1\", \"r\": \"rose\", \"f\": \"move\", \"p\": {},"
          + " \"t\": \"soon\", \"from\": \"stranger\", \"password\": \"hunter2\"}";
  private static final String SENTENCE =
      "The message's t must be a whole number from 1 to 604800000, but is \"soon\".";

  private static ServedHome home;
  private static Transport stranger;

  @BeforeAll
  static void start() throws Exception {
    home = ServedHome.start();
    stranger = new PahoTransport(home.site().broker().orElseThrow(), "stranger");
    CompletableFuture<Boolean> there = new CompletableFuture<>();
    stranger.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            there.complete(true);
          }

          @Override
          public void lost(String reason) {
            there.complete(false);
          }
        });
    assertThat(there.get(60, TimeUnit.SECONDS)).isTrue();
    // What is said before the console listens, it has not heard.
    Awaitility.await()
        .atMost(LIMIT)
        .until(() -> home.get("/bus").document().path("listening").asBoolean());
    home.state("(nextTo Cup Bob)");
  }

  @AfterAll
  static void end() {
    if (stranger != null) {
      stranger.close();
    }
    home.close();
  }

  private static void say(String topic, String payload) {
    stranger.publish(
        Publication.reliable("rats/1/served/" + topic, payload.getBytes(UTF_8), Optional.empty()),
        failure -> {});
  }

  @Test
  void theBusIsToldWithWhatIsWrong() throws Exception {
    say("call/stranger", WRONG);
    say("member/lamp-b1/mood", "x".repeat(10_000));

    JsonNode wrong = awaitMessage("/served/call/stranger");
    JsonNode unknown = awaitMessage("/member/lamp-b1/mood");
    JsonNode state = awaitMessage("/member/rose/state");

    home.assertValid(home.get("/bus").document(), "bus");
    assertThat(wrong.path("problem").asText()).isEqualTo(SENTENCE);
    assertThat(wrong.path("from").asText()).isEqualTo("stranger");
    assertThat(wrong.path("to").asText()).isEqualTo("rose");
    assertThat(wrong.path("payload").asText()).contains("\"password\": \"•••\"");
    assertThat(unknown.path("problem").asText())
        .isEqualTo("No message of the bus has the topic rats/1/served/member/lamp-b1/mood.");
    assertThat(unknown.path("shortened").asBoolean()).isTrue();
    assertThat(unknown.path("bytes").asInt()).isEqualTo(10_000);
    assertThat(state.path("problem").isNull()).as(state.toString()).isTrue();
    JsonNode whole = home.get("/bus/" + unknown.path("number").asText()).document();
    home.assertValid(whole, "bus-message");
    assertThat(whole.path("payload").asText()).hasSize(10_000);
  }

  /** One id runs through the goal, what its agents agree on, the calls and their results. */
  @Test
  void aGoalIsTracedFromItsStoryToTheResultsOfItsCalls() throws Exception {
    String goal = home.get("/goals").document().at("/goals/0/id").asText();
    JsonNode document =
        Awaitility.await()
            .atMost(LIMIT)
            .until(
                () -> home.get("/goals/" + goal + "/trace").document(),
                trace ->
                    ofKind(trace, "story end").findAny().isPresent()
                        && callsOf(trace, "bus result").equals(callsOf(trace, "bus call")));

    home.assertValid(document, "trace");
    for (String kind :
        List.of(
            "story plan",
            "agents cfp",
            "agents propose",
            "agents accept-proposal",
            "agents agree",
            "agents inform",
            "bus progress",
            "bus observation")) {
      assertThat(ofKind(document, kind)).as(kind).isNotEmpty();
    }
    assertThat(callsOf(document, "bus call"))
        .as("a pick, a move, a place at least")
        .hasSizeGreaterThan(2);
    assertThat(
            ofKind(document, "bus call")
                .filter(call -> !call.path("text").asText().startsWith("$cancel ")))
        .as("each call was ordered")
        .allMatch(call -> callsOf(document, "agents request").contains(call.path("call").asText()));
    assertThat(home.get("/goals/G999/trace").problem()).contains("There is no trace of G999");
  }

  private static Stream<JsonNode> ofKind(JsonNode trace, String kind) {
    return StreamSupport.stream(trace.path("trace").spliterator(), false)
        .filter(
            entry ->
                (entry.path("layer").asText() + " " + entry.path("kind").asText()).equals(kind));
  }

  private static Set<String> callsOf(JsonNode trace, String kind) {
    return ofKind(trace, kind)
        .map(entry -> entry.path("call").asText())
        .collect(Collectors.toSet());
  }

  /** What the devices and the platform themselves say is as the documents have it. */
  @Test
  void nothingOfOursIsWrong() throws Exception {
    awaitConversation(one -> one.path("state").asText().equals("done"));

    assertThat(
            StreamSupport.stream(home.get("/bus").document().path("messages").spliterator(), false))
        .filteredOn(message -> !message.path("topic").asText().matches(".*(stranger|mood)"))
        .isNotEmpty()
        .allMatch(message -> message.path("problem").isNull());
  }

  @Test
  void theContractNetIsAConversation() throws Exception {
    JsonNode round = awaitConversation(TrafficTest::isContractNet);
    String id = round.path("id").asText();
    JsonNode whole = home.get("/conversations/" + id).document();

    home.assertValid(home.get("/conversations").document(), "conversations");
    home.assertValid(whole, "conversation");
    assertThat(whole.at("/participants/0").asText()).isEqualTo("CCA");
    assertThat(whole.at("/performatives/cfp").asInt()).isPositive();
    assertThat(whole.path("sequence").findValuesAsText("performative"))
        .startsWith("cfp")
        .contains("propose", "accept-proposal", "inform");
    assertThat(whole.at("/sequence/0/content").asText()).contains("(nextTo Cup Bob)");
    assertThat(
            home.get("/conversations").document().path("conversations").findValuesAsText("subject"))
        .as("what the console asks all the time is left out")
        .doesNotContain("(query-ref)");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "/bus/x                | There is no message x of the bus",
        "/bus/999999999999999999999 | There is no message 9",
        "/bus?page=1           | There is no parameter page here",
        "/conversations/C99999 | There is no conversation C99999",
        "/conversations/%22    | There is no conversation \""
      })
  void whatIsNotThereIsASentence(String path, String sentence) throws Exception {
    ServedHome.Answer answer = home.get(path);

    assertThat(answer.status()).isEqualTo(400);
    home.assertValid(answer.document(), "problem");
    assertThat(answer.problem()).startsWith(sentence);
  }

  @ParameterizedTest
  @CsvSource({"bus, messages", "conversations, conversations"})
  void whoListensHearsWhatIsKeptAndThenWhatComesOnce(String name, String rows) throws Exception {
    HttpResponse<InputStream> response =
        home.stream(home.to("/events/" + name).header("Accept", "text/event-stream").build());
    List<JsonNode> heard = new ArrayList<>();
    try (BufferedReader lines = new BufferedReader(new InputStreamReader(response.body(), UTF_8))) {
      for (String line = lines.readLine(); line != null; line = lines.readLine()) {
        if (line.startsWith("data: ")) {
          heard.add(new ObjectMapper().readTree(line.substring("data: ".length())));
          if (heard.size() == 1) {
            say("call/stranger", WRONG);
            home.state("(canSee ?who Bob)");
          } else if (!heard.get(heard.size() - 1).path(rows).isEmpty()) {
            break;
          }
        }
      }
    }
    for (JsonNode news : heard) {
      home.assertValid(news, name);
    }
    assertThat(heard).as("what is kept, and then what comes").hasSizeGreaterThan(1);
    Set<String> numbers = new HashSet<>();
    for (JsonNode news : heard) {
      news.path(rows)
          .findValuesAsText(name.equals("bus") ? "number" : "latest")
          .forEach(number -> assertThat(numbers.add(number)).as("%s once", number).isTrue());
    }
  }

  /** What a room looks like is for who looks now (ADE, 3.3; A44). */
  @Test
  void aStreamIsHeardByWhoAsksForThatMemberAndIsNotKept() throws Exception {
    String topic = "member/cam-a/stream/streamPictures";
    String frame =
        "{\"v\": \"1.4\", \"id\": \"c1\", \"from\": \"cam-a\", \"f\": \"streamPictures\", \"n\": 7,"
            + " \"at\": %d, \"type\": \"image/png\", \"data\": \"iVBORw==\"}";
    HttpResponse<InputStream> response =
        home.stream(
            home.to("/events/streams?of=cam-a").header("Accept", "text/event-stream").build());
    List<JsonNode> all = new ArrayList<>();
    try (BufferedReader lines = new BufferedReader(new InputStreamReader(response.body(), UTF_8))) {
      for (String line = lines.readLine(); line != null && all.isEmpty(); line = lines.readLine()) {
        if (line.startsWith("data: ")) {
          all.add(new ObjectMapper().readTree(line.substring("data: ".length())));
        } else if (line.startsWith(":")) {
          say("member/cam-b/stream/streamPictures", frame.formatted(0));
          say(topic, "{\"v\": \"1.4\"}");
          say(topic, frame.formatted(System.currentTimeMillis()));
        }
      }
    }
    assertThat(all).hasSize(1);
    JsonNode heard = all.get(0);
    assertThat(heard.path("member").asText()).isEqualTo("cam-a");
    assertThat(heard.path("number").asInt()).isEqualTo(7);
    assertThat(heard.path("data").asText()).isEqualTo("iVBORw==");
    assertThat(heard.has("delay_ms")).isTrue();
    say("member/lamp-b2/mood", "whatever comes after it");
    awaitMessage("/member/lamp-b2/mood");
    assertThat(home.get("/bus").document().toString()).doesNotContain("/stream/");
  }

  @Test
  void thePageDrawsTheContractNetAndMarksWhatIsWrong() throws Exception {
    assumeTrue(
        Browser.isThere(),
        "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.");
    String id = awaitConversation(TrafficTest::isContractNet).path("id").asText();
    say("call/stranger", WRONG);
    try (Browser browser = Browser.open()) {
      browser.size(1440, 900);
      browser.go(home.uri() + "/#view=conversations&conversation=" + id);
      browser.waitForText("#detail .heads", "rose");
      browser.waitForText("#conversation-list", "(nextTo Cup Bob)");
      assertThat(browser.text("#detail .said .label"))
          .contains("cfp", "propose", "accept-proposal");
      assertThat(browser.text("#detail .heads")).contains("CCA", "lamp-b1", "cam-a");

      browser.click("#detail .said");
      browser.waitForText("#detail .content", "cfp, CCA to ");
      browser.waitForText("#detail .content pre", "(nextTo Cup Bob)");
      assertThat(browser.address()).contains("said=");
      assertThat(Accessibility.faults(browser)).isEmpty();

      browser.click("[data-view=bus]");
      // The list shows the latest alone.
      say("call/stranger", WRONG);
      browser.waitForText("#bus-list", SENTENCE);
      browser.click("#bus-wrong");
      browser.waitForText("#bus-list tr.wrong", SENTENCE);
      assertThat(
              browser.run(
                  "return document.querySelectorAll('#bus-list tbody tr:not(.wrong)').length"))
          .isEqualTo(0L);
      browser.click("#bus-list .row");
      browser.waitForText("#detail pre", "\"r\": \"rose\"");
      assertThat(browser.text("#detail pre")).doesNotContain("hunter2");
      browser.click("#bus-pause");
      say("call/stranger", WRONG);
      browser.waitForText("#bus-pause", "Go on (");
      browser.size(390, 844);
      browser.theme("dark");
      say("call/stranger", WRONG);
      browser.waitForText("#bus-list", SENTENCE);
      assertThat(Accessibility.faults(browser)).isEmpty();
      assertThat(browser.run("return document.documentElement.scrollWidth <= innerWidth"))
          .as("nothing is cut off")
          .isEqualTo(true);
      assertThat(browser.complaints()).isEmpty();
    }
  }

  private static boolean isContractNet(JsonNode conversation) {
    return conversation.path("protocol").asText().equals("fipa-contract-net")
        && conversation.path("state").asText().equals("done")
        && conversation.path("subject").asText().contains("(nextTo Cup Bob)");
  }

  private static JsonNode awaitConversation(Predicate<JsonNode> wanted) {
    return await("/conversations", "conversations", wanted);
  }

  private static JsonNode awaitMessage(String topic) {
    return await("/bus", "messages", message -> message.path("topic").asText().endsWith(topic));
  }

  private static JsonNode await(String path, String rows, Predicate<JsonNode> wanted) {
    return Awaitility.await()
        .atMost(LIMIT)
        .until(
            () ->
                StreamSupport.stream(home.get(path).document().path(rows).spliterator(), false)
                    .filter(wanted)
                    .findFirst(),
            Optional::isPresent)
        .orElseThrow();
  }
}
