package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.time.Duration;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/** A goal that is a script: its steps on the page, and what is stated again with it. */
@Isolated("its time is wall time, which others beside it would take")
class ScriptPageTest {
  private static final String NO_BROWSER =
      "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.";
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static ServedHome home;

  @BeforeAll
  static void start() {
    home =
        ServedHome.startWithMore(
            """

            home:linger a maestro:Script ; maestro:arguments () ;
              maestro:body \"""(seq (wait 0.1) (try (wait 100000) (finally (wait 0.1))) (wait 0.2))\""" .
            """);
  }

  @AfterAll
  static void end() {
    home.close();
  }

  private static JsonNode step(String goal, String path) throws Exception {
    for (JsonNode step : home.get("/goals/" + goal + "/plans").document().path("script")) {
      if (step.path("path").asText().equals(path)) {
        return step;
      }
    }
    throw new IllegalStateException("There is no step " + path + " of " + goal);
  }

  @Test
  void theStepsOfAScriptAreShownDoneUnderWayAndToCome() throws Exception {
    String goal = home.state("(linger)");
    Awaitility.await()
        .atMost(LIMIT)
        .until(() -> step(goal, "2.1").path("state").asText().equals("under-way"));
    home.assertValid(home.get("/goals/" + goal + "/plans").document(), "plans");
    assertThat(step(goal, "1").path("state").asText()).isEqualTo("done");
    assertThat(step(goal, "3").path("text").asText()).isEqualTo("(wait 0.2)");
    assertThat(step(goal, "3").path("state").asText()).isEqualTo("waiting");

    assumeTrue(Browser.isThere(), NO_BROWSER);
    try (Browser browser = Browser.open()) {
      browser.size(1440, 900);
      browser.complaints();
      browser.go(home.uri() + "/#view=goals&show=plan&goal=" + goal);

      browser.waitForText("#detail [data-path='1'] .state", "done after");
      browser.waitForText("#detail [data-path='2'] [data-path='2.1'] .state", "under way for");
      browser.waitForText("#detail [data-path='2.2']", "finally (wait 0.1)");
      browser.waitForText("#detail [data-path='3'] .state", "to come");
      assertForEverybody(browser, 1440, 900);
      assertForEverybody(browser, 390, 844);

      browser.size(1440, 900);
      home.delete("/goals/" + goal);
      browser.waitForText("#detail [data-path='2.1'] .state", "called off after");
      browser.waitForText("#detail [data-path='2.2'] .state", "done after");
      browser.waitForText("#detail [data-path='3'] .state", "dropped");
      browser.click("#detail [data-show=bids]");
      browser.waitForText("#detail .empty", "This goal is a script");
      assertThat(browser.complaints()).isEmpty();
    }
  }

  private static void assertForEverybody(Browser browser, int width, int height)
      throws IOException {
    browser.size(width, height);
    assertThat(Accessibility.faults(browser)).as("%d", width).isEmpty();
    assertThat(browser.run("return document.documentElement.scrollWidth <= innerWidth"))
        .as("nothing is cut off at %d", width)
        .isEqualTo(true);
  }

  @Test
  void whatIsStatedAgainKeepsWhatWasStatedWithIt() throws Exception {
    assumeTrue(Browser.isThere(), NO_BROWSER);
    String goal =
        home.post(
                "/goals",
                """
                {"goal": "(linger)", "priority": 3, "deadline_s": 90000, "benefit": "(+ 40 20)",
                 "chance": 0.5, "allowed_s": 700, "urgency_from": 2, "urgency_to": 4}
                """)
            .document()
            .path("id")
            .asText();
    home.delete("/goals/" + goal);
    try (Browser browser = Browser.open()) {
      browser.size(1440, 900);
      browser.go(home.uri() + "/#view=goals&goal=" + goal);
      browser.waitForText("#detail h2", "cancelled");

      browser.click("#detail h2 > button");

      browser.waitForText("#detail h2", "Cancel goal");
      JsonNode goals = home.get("/goals").document().path("goals");
      JsonNode again = goals.get(goals.size() - 1);
      assertThat(again.path("id").asText()).isNotEqualTo(goal);
      assertThat(again.path("priority").asInt()).isEqualTo(3);
      assertThat(again.path("deadline_s").asDouble() + again.path("age_s").asDouble())
          .isBetween(89_999.0, 90_001.0);
      assertThat(again.path("stakes").toString())
          .isEqualTo(
              "{\"benefit\":\"(+ 40 20)\",\"chance\":0.5,\"allowed_s\":700.0,"
                  + "\"urgency_from\":2.0,\"urgency_to\":4.0}");
      home.delete("/goals/" + again.path("id").asText());
    }
  }
}
