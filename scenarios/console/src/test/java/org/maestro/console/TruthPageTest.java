package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.hal.Position;

/** Who develops sees beliefs and truth differ, where there is a truth to be had. */
@Isolated("its time is wall time, which others beside it would take")
class TruthPageTest {
  private static final String NO_BROWSER =
      "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.";

  @Test
  void truthIsDrawnBesideWhatIsBelievedWhileItIsOn() throws Exception {
    try (ServedHome home = ServedHome.start()) {
      JsonNode truth = home.get("/truth").document();
      home.assertValid(truth, "truth");
      assertThat(truth.findValuesAsText("name")).contains("Bob", "Cup", "rose", "lamp-a1");
      assertThat(home.get("/platform").document().path("simulated").asBoolean()).isTrue();

      assumeTrue(Browser.isThere(), NO_BROWSER);
      try (Browser browser = Browser.open()) {
        browser.size(1440, 900);
        browser.complaints();
        browser.go(home.uri() + "/#view=goals");
        browser.waitForText("#plan", "room A");
        assertThat(browser.waitFor("#truth-told").isDisplayed()).as("off by default").isFalse();
        assertThat(browser.text("#plan .truth")).isEmpty();

        browser.waitFor("#truth-on:not(:disabled)").click();
        browser.waitForText("#truth-told", "Simulated truth is drawn");
        browser.waitForText("#truth-told", "Cup is at ");
        browser.waitForText("#truth-told", "and nobody knows where");
        browser.waitForText("#plan .truth [data-true=Cup]", "truly Cup");
        assertThat(browser.address()).contains("truth=on");

        home.site().world().setDoor("door-ab", false);
        browser.waitForText("#truth-told", "door-ab is shut, and is believed to be open");
        browser.waitForText("#plan .truth [data-true=door-ab]", "truly shut");

        home.state("(canSee ?who Bob)");
        browser.waitFor("#plan .things [data-thing=Bob]");
        home.site().world().moveByHand("Bob", new Position(5.5, 0.5, 0));
        browser.waitForText("#truth-told", "Bob is at 5.5 0.5, ");
        browser.waitForText("#truth-told", "m from where it was known to be last");
        browser.waitFor("#plan .truth [data-true=Bob] .true-way");
        Accessibility.assertForEverybody(browser, "#plan .truth", "truly Cup");

        browser.waitFor("#truth-on").click();
        browser.waitFor("#truth-told[hidden]");
        assertThat(browser.run("return document.querySelector('#plan .truth')")).isNull();
        assertThat(browser.complaints()).isEmpty();
      }
    }
  }

  @Test
  void whereNothingIsSimulatedTheSwitchIsGreyedWithTheReason() throws Exception {
    try (ServedHome home = ServedHome.startUntrue()) {
      ServedHome.Answer answer = home.get("/truth");
      assertThat(answer.status()).isEqualTo(404);
      home.assertValid(answer.document(), "problem");
      assertThat(answer.problem()).startsWith("This process simulates nothing (--no-sim)");

      assumeTrue(Browser.isThere(), NO_BROWSER);
      try (Browser browser = Browser.open()) {
        browser.size(1440, 900);
        browser.go(home.uri() + "/#view=goals&truth=on");
        browser.waitFor("#truth-on:disabled:not(:checked)");
        browser.waitForText("#truth-why", "This process simulates nothing");
        assertThat(browser.text("#plan .truth")).isEmpty();
      }
    }
  }
}
