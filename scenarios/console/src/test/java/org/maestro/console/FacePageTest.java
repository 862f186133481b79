package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.time.Duration;
import java.util.function.UnaryOperator;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/**
 * A page that shows a face draws what is said where it hangs, as whoever says it (ADE, 3.3 and 5;
 * A41, A42, A90).
 */
@Isolated("its time is wall time, which others beside it would take")
class FacePageTest {
  private static final String NO_BROWSER =
      "The page is not tried: there is no chromium with its chromedriver; .ci/install installs"
          + " them.";
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final String SMILE =
      "{\"feature\": \"express\", \"parameters\": {\"expression\": \"smile\", \"intensity\": 1}}";
  private static final String LOOK =
      "{\"feature\": \"lookAt\", \"parameters\": {\"thing\": \"tv\"}}";
  private static final String STREAM = "{\"feature\": \"streamPictures\", \"parameters\": {}}";
  private static final String STOP = "{\"feature\": \"stopStreaming\", \"parameters\": {}}";
  private static final String DONE = "\"state\":\"done\"";

  @Test
  void theKitchenAnswersAtTheLivingRoomsScreenWhichFollowsWhatIsSaid() throws Exception {
    try (ServedHome home = ServedHome.startRooms(UnaryOperator.identity())) {
      assertThat(ended(home, SMILE))
          .contains("no page shows this face; open face.html#screen-living");
      home.assertValid(home.get("/faces").document(), "faces");

      assumeTrue(Browser.isThere(), NO_BROWSER);
      try (Browser browser = Browser.open()) {
        browser.size(1440, 900);
        browser.complaints();
        browser.open(home.uri() + "/face.html");
        browser.waitForText("#choice-list", "the living room's face");
        browser.open(home.uri() + "/face.html#screen-living");
        browser.waitForText("#screen", "the living room's face");
        browser.waitForText("#doing", "Nobody has spoken here yet.");
        assertThat(ended(home, SMILE)).as("a page shows it now").contains(DONE);
        browser.waitForText("#doing", "smiles");

        new PersonInChat(home, "Rose", "livingroom")
            .says("Heat up the pasta from last night.", "The pasta is warm.");
        browser.waitForText("#persona", "Kitchen");
        browser.waitForText("#sentence", "The pasta is warm.");
        browser.waitForText("#doing", "smiles");
        assertThat(ended(home, LOOK)).contains(DONE);
        browser.waitForText("#doing", "looks at the television");
        Accessibility.assertForEverybody(browser, "#persona", "Kitchen");

        // The kitchen's camera, on the living room's screen (ADE, 3.3; A44).
        browser.open(home.uri() + "/stream.html#cam-kitchen");
        browser.waitForText("#nothing", "The kitchen's camera streams nothing now");
        home.post("/members/cam-kitchen/calls", STREAM);
        browser.waitForText("#told", "captured at");
        home.post("/members/cam-kitchen/calls", STOP);
        browser.waitForText("#nothing", "The kitchen's camera streams nothing now");
        assertThat(browser.complaints()).isEmpty();
      }
    }
  }

  /** What has become of a call by hand, such as why it has failed. */
  private static String ended(ServedHome home, String call) throws Exception {
    String id = home.post("/members/screen-living/calls", call).document().path("id").asText();
    return Awaitility.await()
        .atMost(LIMIT)
        .until(
            () -> home.get("/calls/" + id).document(),
            made -> !made.path("state").asText().equals("under-way"))
        .toString();
  }
}
