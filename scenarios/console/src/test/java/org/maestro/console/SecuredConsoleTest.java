package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.InputStream;
import java.net.URLEncoder;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.knowledge.api.Source;
import org.maestro.rats.security.Role;
import org.maestro.rats.security.SecureSite;

/** The console of a secured site: who is let in, as whom, and what each may. */
@Isolated("its time is wall time, which others beside it would take")
class SecuredConsoleTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);

  /**
   * Alice may have everybody asked, and is told what Dave likes; Erin may have everybody asked; the
   * others have no permission in the home.
   */
  private static final String PERMISSIONS =
      """

      home:aliceAsks a maestro:Permission ; maestro:caller "alice" .
      :prefers maestro:private true .
      home:Dave a :Person ; rdfs:label "Dave"@en .
      home:Opera a :Show ; rdfs:label "the opera"@en .
      home:dave-evenings a :Preference ; rdfs:label "what Dave likes in the evening"@en ;
        :preferenceOf home:Dave ; :preferenceAbout "TV show" ; :prefers home:Opera .
      home:erinAsks a maestro:Permission ; maestro:caller "erin" .
      home:suit a maestro:Script ; maestro:arguments () ;
        maestro:body "(let ?show (one (?s - Show) (prefers dave-evenings ?s)) (wait 0.1))" .
      home:aliceIsTold a maestro:Permission ; maestro:caller "alice" ; maestro:reads :prefers .
      """;

  private static final String LIKES =
      URLEncoder.encode("(prefers dave-evenings ?show)", StandardCharsets.UTF_8);
  private static final String LIKED =
      URLEncoder.encode("(prefers dave-evenings Opera)", StandardCharsets.UTF_8);

  @TempDir static Path files;
  private static ServedHome home;

  @BeforeAll
  static void start() {
    home =
        ServedHome.startSecured(
            files,
            Map.of(
                "alice", Role.OPERATOR,
                "erin", Role.OPERATOR,
                "mallory", Role.OPERATOR,
                "screen", Role.VIEWER,
                "carol", Role.ADMINISTRATOR,
                "leaver", Role.VIEWER,
                "renewed", Role.VIEWER,
                "revoked", Role.VIEWER),
            PERMISSIONS);
  }

  @AfterAll
  static void end() {
    home.close();
  }

  private static String password(String person) throws Exception {
    return Files.readString(files.resolve("users/" + person + "/console-password")).strip();
  }

  private static HttpRequest.Builder as(String person, String path) throws Exception {
    String both = person + ":" + password(person);
    return home.to(path)
        .header(
            "Authorization",
            "Basic " + Base64.getEncoder().encodeToString(both.getBytes(StandardCharsets.UTF_8)));
  }

  private static HttpRequest.Builder posting(HttpRequest.Builder request, String body) {
    return request
        .header("Content-Type", "application/json")
        .POST(HttpRequest.BodyPublishers.ofString(body));
  }

  /** A session as a browser has it: its cookie, and the token of its page. */
  private record Signed(String cookie, String csrf) {
    HttpRequest.Builder to(String path) {
      return home.to(path).header("Cookie", cookie);
    }
  }

  private static Signed signIn(String person) throws Exception {
    HttpResponse<String> answer =
        home.sendWhole(
            posting(
                home.to("/session"),
                new ObjectMapper()
                    .createObjectNode()
                    .put("name", person)
                    .put("password", password(person))
                    .toString()));
    assertThat(answer.statusCode()).as(answer.body()).isEqualTo(200);
    JsonNode told = new ObjectMapper().readTree(answer.body());
    home.assertValid(told, "session");
    String cookie = answer.headers().firstValue("Set-Cookie").orElseThrow();
    assertThat(cookie)
        .startsWith("__Host-maestro-" + home.uri().getPort() + "=")
        .contains("; Secure", "; HttpOnly", "; SameSite=Strict", "; Path=/");
    return new Signed(cookie.split(";")[0], told.path("csrf").asText());
  }

  @ParameterizedTest
  @ValueSource(strings = {"/goals", "/facts", "/agents", "/history", "/events", "/events/bus"})
  void nobodyIsToldAnythingBeforeSheHasSignedIn(String path) throws Exception {
    HttpResponse<String> answer = home.sendWhole(home.to(path));
    assertThat(answer.statusCode()).isEqualTo(401);
    assertThat(answer.headers().firstValue("WWW-Authenticate")).contains("Session");
    assertThat(answer.body()).contains("sign in first");
  }

  @Test
  void whoWatchesOverProcessesIsToldThatAllIsWellAndNoMore() throws Exception {
    assertThat(home.whole("/").statusCode()).as("the page, to sign in at").isEqualTo(200);
    assertThat(home.whole("/health").body()).isEqualTo("{\"status\":\"well\"}");
    assertThat(home.whole("/ready").statusCode()).isEqualTo(200);
    assertThat(home.whole("/metrics").statusCode()).isEqualTo(401);
    assertThat(home.get("/openapi.json").status()).isEqualTo(200);
    JsonNode nobody = home.get("/session").document();
    home.assertValid(nobody, "session");
    assertThat(nobody.path("secured").asBoolean()).isTrue();
    assertThat(nobody.path("person").isNull()).isTrue();
  }

  @Test
  void aWrongPasswordLetsNobodyIn() throws Exception {
    HttpResponse<String> answer =
        home.sendWhole(
            posting(home.to("/session"), "{\"name\": \"alice\", \"password\": \"guessed\"}"));
    assertThat(answer.statusCode()).isEqualTo(401);
    assertThat(answer.body()).contains("The name or the password is wrong");
    assertThat(answer.headers().firstValue("Set-Cookie")).isEmpty();
  }

  @Test
  void aGoalThatIsStatedInASessionIsThatPersons() throws Exception {
    Signed alice = signIn("alice");
    JsonNode told = home.send(alice.to("/session")).document();
    assertThat(told.path("person").asText()).isEqualTo("alice");
    assertThat(told.path("role").asText()).isEqualTo("operator");
    String goal = "{\"goal\": \"(canSee ?who Bob)\"}";
    ServedHome.Answer forged = home.send(posting(alice.to("/goals"), goal));
    assertThat(forged.status()).as("a page of another site has no token").isEqualTo(403);
    assertThat(forged.problem()).contains("X-CSRF-Token");

    ServedHome.Answer stated =
        home.send(posting(alice.to("/goals").header("X-CSRF-Token", alice.csrf()), goal));

    assertThat(stated.status()).as(stated.toString()).isEqualTo(201);
    String id = stated.document().path("id").asText();
    assertThat(
            home.send(alice.to("/goals/" + id + "/story")).document().at("/story/0/text").asText())
        .startsWith("desk@alice asks for");
    await(() -> state(alice, id).equals("achieved"));
  }

  private static String state(Signed person, String goal) throws Exception {
    for (JsonNode row : home.send(person.to("/goals")).document().path("goals")) {
      if (row.path("id").asText().equals(goal)) {
        return row.path("state").asText();
      }
    }
    return "";
  }

  /** The same names as in the platform: what the home permits counts, whatever the role. */
  @Test
  void whomTheHomePermitsNothingIsRefusedThoughSheMayStateGoals() throws Exception {
    ServedHome.Answer refused =
        home.send(posting(as("mallory", "/goals"), "{\"goal\": \"(canSee ?who Bob)\"}"));
    assertThat(refused.status()).isEqualTo(400);
    assertThat(refused.problem())
        .contains("No maestro:Permission of the home lets desk or mallory");
    String call = "{\"feature\": \"adjustLight\", \"parameters\": {\"level\": 0.5}}";
    assertThat(home.send(posting(as("mallory", "/members/lamp-b1/calls"), call)).problem())
        .contains("no maestro:Permission", "mallory");
    assertThat(home.send(posting(as("alice", "/members/lamp-b1/calls"), call)).status())
        .isEqualTo(201);
  }

  /** Private facts by permission only (ADE, 4.1; A30, A57), each way that the console has. */
  @Test
  void whatIsPrivateIsToldToWhomTheHomePermitsIt() throws Exception {
    JsonNode told = home.send(as("alice", "/knowledge?question=" + LIKES)).document();
    assertThat(told.at("/answers/0/binding/show").asText()).isEqualTo("Opera");
    assertThat(told.at("/answers/0/source").asText()).isEqualTo("bob-secured.ttl");
    assertThat(told.at("/answers/0/because/0/kind").asText()).isEqualTo("described");
    assertThat(home.send(as("alice", "/knowledge/history?fact=" + LIKED)).status()).isEqualTo(200);

    String sentence =
        "prefers is private in this home, and no maestro:Permission lets desk or mallory read it";
    String query = "{\"query\": \"SELECT * WHERE { GRAPH ?g { ?a ?b ?c } }\"}";
    for (ServedHome.Answer refused :
        List.of(
            home.send(as("mallory", "/knowledge?question=" + LIKES)),
            home.send(as("mallory", "/knowledge/history?fact=" + LIKED)),
            home.send(posting(as("mallory", "/queries"), query)))) {
      assertThat(refused.status()).isEqualTo(400);
      home.assertValid(refused.document(), "problem");
      assertThat(refused.problem()).contains(sentence).doesNotContain("Opera");
    }
    assertThat(home.send(posting(as("alice", "/queries"), query)).status()).isEqualTo(200);
  }

  /** What a script uses, and what a goal speaks of, stands in their stories. */
  @Test
  void goalsThatUseWhatIsPrivateAreToldOfByPermissionToo() throws Exception {
    String script = stated("alice", "(suit)");
    String goal = stated("alice", "(prefers dave-evenings Opera)");
    for (String id : List.of(script, goal)) {
      await(() -> row("alice", id).path("state").asText().equals("achieved"));
      assertThat(home.send(as("alice", "/goals/" + id + "/story")).document().toString())
          .contains("Opera");
    }
    assertThat(home.send(as("alice", "/goals/" + script + "/plans")).status()).isEqualTo(200);

    String body = "{\"goal\": \"(prefers dave-evenings Opera)\"}";
    for (ServedHome.Answer refused :
        List.of(
            home.send(as("erin", "/goals/" + script + "/story")),
            home.send(as("erin", "/goals/" + script + "/plans")),
            home.send(as("erin", "/goals/" + goal + "/story")),
            home.send(as("erin", "/goals/" + goal + "/bids")),
            home.send(posting(as("erin", "/previews"), body)),
            home.send(posting(as("erin", "/goals"), body)))) {
      assertThat(refused.status()).as(refused.toString()).isEqualTo(400);
      assertThat(refused.problem())
          .contains(
              "prefers is private in this home, and no maestro:Permission lets desk or erin read"
                  + " it")
          .doesNotContain("Opera");
    }
    home.assertValid(home.send(as("erin", "/goals")).document(), "goals");
    assertThat(row("alice", goal).path("goal").asText()).contains("Opera");
    assertThat(row("erin", goal).path("goal").asText()).isEqualTo("private");
    assertThat(row("erin", script).path("goal").asText()).isEqualTo("(suit)");
    assertThat(row("erin", script).path("detail").isNull()).isTrue();
  }

  private static String stated(String person, String goal) throws Exception {
    ServedHome.Answer answer =
        home.send(posting(as(person, "/goals"), "{\"goal\": \"" + goal + "\"}"));
    assertThat(answer.status()).as(answer.toString()).isEqualTo(201);
    return answer.document().path("id").asText();
  }

  private static JsonNode row(String person, String goal) throws Exception {
    JsonNode goals = home.send(as(person, "/goals")).document().path("goals");
    for (JsonNode row : goals) {
      if (row.path("id").asText().equals(goal)) {
        return row;
      }
    }
    return goals.path("none");
  }

  @Test
  void listsLeaveOutWhatIsPrivateAndSayHowMuch() throws Exception {
    home.site()
        .platform()
        .knowledge()
        .state(
            new Source(Source.Kind.STATED, "somebody"), List.of("(prefers dave-evenings Opera)"));
    JsonNode whole = home.send(as("alice", "/facts")).document();
    home.assertValid(whole, "facts");
    assertThat(whole.path("left_out").asInt()).isZero();
    assertThat(whole.toString()).contains("(prefers dave-evenings Opera)");
    JsonNode part = home.send(as("mallory", "/facts")).document();
    home.assertValid(part, "facts");
    assertThat(part.path("left_out").asInt()).isEqualTo(1);
    assertThat(part.toString()).doesNotContain("Opera");
  }

  /** All who look read what is said there, so that it is not told even to whom it might be. */
  @Test
  void theChatIsHeardByAllAndTellsNothingPrivate() throws Exception {
    String said =
        "{\"person\": \"Bob\", \"room\": \"room-a\", \"text\": \"? (prefers dave-evenings"
            + " ?show)\"}";
    ServedHome.Answer accepted = home.send(posting(as("alice", "/chat"), said));
    assertThat(accepted.status()).as(accepted.toString()).isEqualTo(201);
    await(() -> home.send(as("screen", "/chat")).document().toString().contains("is private"));
    assertThat(home.send(as("screen", "/chat")).document().toString()).doesNotContain("Opera");
  }

  @ParameterizedTest
  @CsvSource({
    "screen, /goals, '{\"goal\": \"(canSee ?who Bob)\"}', an operator",
    "screen, /members/lamp-b1/calls, '{\"feature\": \"adjustLight\"}', an operator",
    "screen, /safe-state, '', an operator",
    "alice, /agents/rose/moves, '{\"to\": \"nowhere\"}', an administrator",
    "alice, /coordinator/revival, '', an administrator",
  })
  void whatTakesAnotherRoleIsRefusedWithTheReason(
      String person, String path, String body, String needed) throws Exception {
    ServedHome.Answer refused = home.send(posting(as(person, path), body));
    assertThat(refused.status()).isEqualTo(403);
    home.assertValid(refused.document(), "problem");
    assertThat(refused.problem()).startsWith(person + " is a").contains("this takes " + needed);
  }

  @Test
  void eachMayWhatHerRoleSays() throws Exception {
    assertThat(home.send(as("screen", "/goals")).status()).isEqualTo(200);
    assertThat(home.sendWhole(as("screen", "/events/streams?of=cam-a")).statusCode())
        .as("what a room looks like is for operators")
        .isEqualTo(403);
    assertThat(
            home.send(posting(as("screen", "/previews"), "{\"goal\": \"(in rose zone-a)\"}"))
                .status())
        .isEqualTo(200);
    ServedHome.Answer moved =
        home.send(posting(as("carol", "/agents/rose/moves"), "{\"to\": \"nowhere\"}"));
    assertThat(moved.status()).as("asked, and refused for another reason").isEqualTo(400);
    assertThat(moved.problem()).contains("nowhere");
  }

  /** It is looked at again with each event, and every ten seconds where there is none. */
  @Test
  void whoIsTakenOutIsLetInNoMoreAndHearsNoMore() throws Exception {
    Signed revoked = signIn("revoked");
    HttpResponse<InputStream> events = home.stream(listening(revoked));
    assertThat(events.statusCode()).isEqualTo(200);

    SecureSite.in(files).revoke(List.of("revoked"));

    assertThat(home.send(revoked.to("/goals")).status()).isEqualTo(401);
    assertEnds(events);
  }

  private static HttpRequest listening(Signed person) {
    return person.to("/events").header("Accept", "text/event-stream").build();
  }

  private static void assertEnds(HttpResponse<InputStream> events) throws Exception {
    try (InputStream told = events.body()) {
      byte[] some = new byte[4096];
      while (told.read(some) >= 0) {
        assertThat(some).isNotEmpty();
      }
    }
  }

  @Test
  void whoGetsANewPasswordHasToSignInAnew() throws Exception {
    Signed renewed = signIn("renewed");
    HttpResponse<InputStream> events = home.stream(listening(renewed));
    assertThat(events.statusCode()).isEqualTo(200);

    SecureSite.in(files).renew(List.of("renewed"));

    assertThat(home.send(renewed.to("/goals")).status()).isEqualTo(401);
    assertEnds(events);
    assertThat(home.send(as("renewed", "/goals")).status()).isEqualTo(200);
  }

  @Test
  void anotherMethodThanThatOfTheRequestIsNotHeeded() throws Exception {
    HttpRequest.Builder request = as("screen", "/goals").header("X-HTTP-Method-Override", "POST");
    assertThat(home.send(request).status()).isEqualTo(403);
  }

  @Test
  void aSessionThatIsEndedIsNoneAnyMore() throws Exception {
    Signed leaver = signIn("leaver");
    HttpResponse<String> left =
        home.sendWhole(leaver.to("/session").header("X-CSRF-Token", leaver.csrf()).DELETE());
    assertThat(left.statusCode()).isEqualTo(204);
    assertThat(left.headers().firstValue("Set-Cookie").orElse("")).contains("=; ", "Max-Age=0");
    assertThat(home.send(leaver.to("/goals")).status()).isEqualTo(401);
  }

  /** What is told of the bus there is heard by a user who may say nothing. */
  @Test
  void theBusIsShown() throws Exception {
    await(() -> !home.send(as("screen", "/bus")).document().path("messages").isEmpty());
  }

  private interface Condition {
    boolean holds() throws Exception;
  }

  private static void await(Condition condition) {
    Awaitility.await().atMost(LIMIT).until(condition::holds);
  }
}
