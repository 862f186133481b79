package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.List;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.sim.scene.ScriptedFault;

/** Members one by one: what they are at, and what people have them do by hand. */
@Isolated("its time is wall time, which others beside it would take")
class MembersTest {
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

  private static JsonNode ended(String call) {
    JsonNode made =
        Awaitility.await()
            .atMost(LIMIT)
            .until(
                () -> home.get("/calls/" + call).document(),
                document -> !document.path("state").asText().equals("under-way"));
    return made;
  }

  private static JsonNode feature(JsonNode member, String name) {
    for (JsonNode feature : member.path("features")) {
      if (feature.path("feature").asText().equals(name)) {
        return feature;
      }
    }
    throw new AssertionError("There is no " + name + " in " + member);
  }

  @Test
  void aCallByHandIsEndedByHand() throws Exception {
    // It takes long enough to be ended on the way.
    home.site().simulated().let("rose", ScriptedFault.parse("at 0.01 slip 0.95"));
    ServedHome.Answer begun =
        home.post(
            "/members/rose/calls",
            "{\"feature\": \"move\", \"parameters\": {\"to\": \"zone-a\"}, \"timeout_s\": 600}");
    String id = begun.document().path("id").asText();
    assertThat(begun.status()).as(begun.toString()).isEqualTo(201);

    assertThat(home.delete("/calls/" + id).status()).isEqualTo(204);

    JsonNode ended = ended(id);
    assertThat(ended.path("state").asText()).as(ended.toString()).isEqualTo("failed");
    assertThat(ended.path("outcome").asText()).containsIgnoringCase("cancel");
    assertThat(home.delete("/calls/" + id).problem()).contains(id + " has ended already");
    assertThat(home.delete("/calls/M999").problem()).contains("There is no call M999");
  }

  @Test
  void oneMemberAloneIsBroughtIntoASafeState() throws Exception {
    String call = "{\"feature\": \"adjustLight\", \"parameters\": {\"level\": 1.0}}";
    for (String lamp : List.of("lamp-b2", "lamp-b3")) {
      ended(home.post("/members/" + lamp + "/calls", call).document().path("id").asText());
    }
    assertThat(stateOf("lamp-b2")).isEqualTo(stateOf("lamp-b3")).isNotEqualTo("safe");

    assertThat(home.post("/members/lamp-b2/safe-state", "").status()).isEqualTo(204);

    Awaitility.await().atMost(LIMIT).until(() -> !stateOf("lamp-b2").equals(stateOf("lamp-b3")));
    assertThat(home.post("/members/lamp-x/safe-state", "").problem())
        .contains("There is no member lamp-x");
  }

  private static String stateOf(String member) throws Exception {
    return home.get("/members/" + member).document().path("state").asText();
  }

  @Test
  void aFeatureIsCalledByHandAndWhatCameOfItIsTold() throws Exception {
    JsonNode before = home.get("/members/lamp-b1").document();
    home.assertValid(before, "member");
    assertThat(feature(before, "adjustLight").path("why_not").isNull()).isTrue();
    assertThat(feature(before, "adjustLight").at("/parameters/0/name").asText()).isEqualTo("level");

    ServedHome.Answer begun =
        home.post(
            "/members/lamp-b1/calls",
            "{\"feature\": \"adjustLight\", \"parameters\": {\"level\": 0.5}}");

    assertThat(begun.status()).as(begun.document().toString()).isEqualTo(201);
    home.assertValid(begun.document(), "call");
    JsonNode made = ended(begun.document().path("id").asText());
    home.assertValid(made, "call");
    assertThat(made.path("state").asText()).as(made.toString()).isEqualTo("done");
    Awaitility.await()
        .atMost(LIMIT)
        .until(
            () ->
                home.get("/knowledge?question=(level%20lamp-b1)")
                        .document()
                        .at("/answers/0/binding/value")
                        .asDouble()
                    == 0.5);
    JsonNode after = home.get("/members/lamp-b1").document();
    assertThat(after.path("round_trip_ms").asDouble()).isPositive();
    assertThat(after.path("queue")).isEmpty();
  }

  /** A camera is pointed at a thing by its name alone; what it needs to know of it is found. */
  @Test
  void aThingIsNamedAndASecondCallWaits() throws Exception {
    ServedHome.Answer first =
        home.post(
            "/members/rose/calls",
            "{\"feature\": \"move\", \"parameters\": {\"to\": \"zone-a\", \"from\": \"zone-b\"}}");
    ServedHome.Answer second =
        home.post(
            "/members/rose/calls",
            "{\"feature\": \"move\", \"parameters\": {\"to\": \"zone-b\", \"from\": \"zone-a\"}}");

    assertThat(first.status()).as(first.document().toString()).isEqualTo(201);
    assertThat(second.status()).as(second.document().toString()).isEqualTo(201);
    assertThat(ended(first.document().path("id").asText()).path("state").asText())
        .isEqualTo("done");
    assertThat(ended(second.document().path("id").asText()).path("state").asText())
        .isEqualTo("done");
  }

  @Test
  void whatIsAskedWronglyIsRefusedInASentence() throws Exception {
    assertThat(home.get("/members/nobody").problem()).contains("There is no member nobody");
    assertThat(problem("nobody", "{\"feature\": \"move\"}"))
        .isEqualTo("Nothing is known that nobody can do.");
    assertThat(problem("lamp-b1", "{\"feature\": \"fly\"}"))
        .isEqualTo("lamp-b1 has no feature fly; it has adjustLight.");
    assertThat(problem("lamp-b1", "{\"feature\": \"adjustLight\"}"))
        .isEqualTo("adjustLight needs the parameter level.");
    assertThat(
            problem(
                "lamp-b1",
                "{\"feature\": \"adjustLight\", \"parameters\": {\"level\": 1, \"hue\": 2}}"))
        .isEqualTo("adjustLight has no parameter hue; it has level.");
    assertThat(home.get("/calls/M999").problem()).contains("There is no call M999");
  }

  private static String problem(String member, String body) throws Exception {
    ServedHome.Answer answer = home.post("/members/" + member + "/calls", body);
    assertThat(answer.status()).isEqualTo(400);
    return answer.problem();
  }

  @Test
  void thePageHasAFormForEachFeatureAndGreysThoseOfWhoIsLost() throws Exception {
    assumeTrue(
        Browser.isThere(),
        "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.");
    try (Browser browser = Browser.open()) {
      browser.size(1440, 900);
      browser.go(home.uri() + "/#view=members&thing=lamp-a1");
      browser.waitForText("#detail", "waiting: nothing");
      browser.waitFor("#detail [data-feature=adjustLight] select");
      browser.run(
          "document.querySelector('#detail [data-feature=adjustLight] select').value = '0.25'");
      browser.click("#detail [data-feature=adjustLight] button");
      browser.waitForText("#detail [data-feature=adjustLight] [role=status]", "✓ M");
      assertThat(
              browser.run(
                  "return document.querySelector('#detail [data-feature=adjustLight] select').value"))
          .as("what was typed stays")
          .isEqualTo("0.25");
      browser.waitForText("#detail", "answers calls in");
      assertThat(Accessibility.faults(browser)).isEmpty();

      home.site().simulated().let("lamp-a1", ScriptedFault.parse("at 0.1 die"));

      browser.waitForText("#detail [data-feature=adjustLight]", "lamp-a1 is lost.");
      browser.waitFor("#detail [data-feature=adjustLight] button[disabled]");
      browser.size(390, 844);
      browser.theme("dark");
      assertThat(Accessibility.faults(browser)).isEmpty();
      assertThat(browser.complaints()).isEmpty();
    }
  }
}
