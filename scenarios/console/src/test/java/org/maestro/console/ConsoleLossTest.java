package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.sim.scene.ScriptedFault;

/** What is lost stays to be seen, and is not shown as if it were there. */
@Isolated("its time is wall time, which others beside it would take")
class ConsoleLossTest {

  @Test
  void aLampThatDiesIsShownLostAndSoIsThePlatform() {
    assumeTrue(
        Browser.isThere(),
        "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.");
    ServedHome home = ServedHome.start();
    try (Browser browser = Browser.open()) {
      browser.size(1440, 900);
      browser.go(home.uri() + "/#view=members");
      browser.waitForText("#member-list", "lamp-b2");
      browser.waitFor("#plan [data-thing=lamp-b2]:not(.lost)");

      home.site().simulated().let("lamp-b2", ScriptedFault.parse("at 0.1 die"));

      browser.waitForText("#plan", "lamp-b2 lost");
      browser.waitFor("#plan [data-thing=lamp-b2].lost");
      browser.waitForText("#member-list", "lost");
      browser.waitForText("#alerts-open", "▲ 1 alert");
      browser.click("#alerts-open");
      browser.waitForText("#alerts", "lamp-b2 is lost");
      browser.click("#plan [data-thing=lamp-b2]");
      browser.waitForText("#detail", "On the bus: lost");
      assertThat(browser.text("#member-list")).as("it stays in the list").contains("lamp-b2");

      home.close();

      browser.waitForText("#link.lost", "The platform does not answer");
      assertThat(browser.text("#member-list")).contains("lamp-b1");
    } finally {
      home.close();
    }
  }
}
