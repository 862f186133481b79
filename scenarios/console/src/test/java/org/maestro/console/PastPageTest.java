package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.openqa.selenium.Keys;

/** Looking back, as a person does it in a real browser. */
@Isolated("its time is wall time, which others beside it would take")
class PastPageTest {
  private static ServedHome home;
  private static Browser browser;

  @BeforeAll
  static void open() throws Exception {
    assumeTrue(
        Browser.isThere(),
        "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.");
    home = ServedHome.start();
    browser = Browser.open();
    browser.size(1440, 900);
    browser.go(home.uri() + "/#view=goals");
    home.state("(in rose zone-a)");
    browser.waitForText("#goal-list", "achieved");
  }

  @AfterAll
  static void close() {
    if (browser != null) {
      browser.close();
    }
    if (home != null) {
      home.close();
    }
  }

  @Test
  void anEventIsGoneBackToAndEverythingIsAsItWasThen() {
    browser.complaints();
    browser.go(home.uri() + "/#view=history");
    browser.waitForText("#detail", "reached");
    String now = browser.waitFor("#plan [data-thing=rose]").getDomAttribute("transform");

    click("stated");

    browser.waitForText("#time.past #time-told", "As of ");
    assertThat(browser.address()).contains("at=20");
    browser.waitFor("#plan [data-thing=rose]:not([transform='" + now + "'])");
    browser.click("[data-view=goals]");
    browser.waitFor("#goal-list .state:not(.good)");
    assertThat(browser.waitFor("#goal-form [type=submit]").isEnabled()).isFalse();
    assertThat(browser.waitFor("#goal-form [type=submit]").getDomAttribute("title"))
        .contains("Go back to now first");
    assertThat(browser.waitFor("#stop").isEnabled()).as("whatever is looked at").isTrue();

    browser.go(browser.address());
    browser.waitFor("#goal-list .state:not(.good)");
    browser.click("#time-now");

    browser.waitForText("#goal-list .state", "achieved");
    browser.waitFor("#plan [data-thing=rose][transform='" + now + "']");
    assertThat(browser.waitFor("#goal-form [type=submit]").isEnabled()).isTrue();
    assertThat(browser.complaints()).isEmpty();
  }

  private static void click(String what) {
    browser.run(
        "[...document.querySelectorAll('#detail tbody tr')]"
            + ".find(row => row.textContent.includes(arguments[0])).click()",
        what);
  }

  @Test
  void theDayOfAPersonIsToldInSentences() throws Exception {
    JsonNode day = home.get("/days/Bob").document();
    home.assertValid(day, "day");
    assertThat(day.path("requests")).isNotEmpty();
    assertThat(home.get("/days/Bobb").problem())
        .isEqualTo("This home has no person Bobb; write Bob, if that is meant.");
    assertThat(home.get("/days/Bob?date=2026-13-01").problem())
        .isEqualTo("date is a day such as 2026-01-31, not \"2026-13-01\".");
    assertThat(home.get("/days/Bob?date=2020-02-29").problem())
        .startsWith("Nothing is kept of 2020-02-29;");

    browser.complaints();
    browser.go(home.uri() + "/#view=history");
    browser.waitForText("#day-person", "Bob");
    browser.run("document.querySelector('#day').open = true");
    browser.waitFor("#day-form button").sendKeys(Keys.ENTER);
    browser.waitForText("#day-told", "asks me to");
    Accessibility.assertForEverybody(browser, "#day-told", "asks me to");
    assertThat(browser.complaints()).isEmpty();
  }

  /** What is drawn before the answer is what is so now, and the bar claims nothing else. */
  @Test
  void aTimeIsNamedOnceItIsShown() {
    browser.go(home.uri() + "/#view=history");
    browser.waitForText("#detail", "stated");
    browser.run(
        """
        const ask = window.fetch;
        const told = new Promise((release) => { window.release = release; });
        window.fetch = (path, ...more) =>
          path.includes("/history/state") ? told.then(() => ask(path, ...more)) : ask(path, ...more);
        """);

    click("stated");

    browser.waitFor("#time-now:not([hidden])");
    assertThat(browser.text("#time-told")).startsWith("Now.");
    browser.run("window.release()");
    browser.waitForText("#time.past #time-told", "As of ");
  }

  @Test
  void theSliderGoesByKeys() {
    browser.go(home.uri() + "/#view=history");
    browser.waitFor("#time-marks .mark");

    browser.waitFor("#time-slider").sendKeys(Keys.ARROW_LEFT);
    browser.waitForText("#time.past #time-told", "As of ");
    browser.waitFor("#time-slider").sendKeys(Keys.HOME);
    browser.waitForText("#nowhere", "rose");
    browser.waitFor("#time-slider").sendKeys(Keys.END);

    browser.waitForText("#time:not(.past) #time-told", "Now.");
    browser.waitFor("#plan [data-thing=rose]");
  }

  @Test
  void whatWasMeasuredIsCharted() {
    browser.go(home.uri() + "/#view=history&thing=lamp-a1");
    browser.waitForText("#charts figcaption", "level of lamp A1");
    browser.waitForText("#charts .legend", "reached or held 1");
    browser.waitForText("#charts .legend", "agents ");

    assertThat(browser.text("#charts figcaption"))
        .contains("Illuminance", "Detections a minute", "Goals", "Answers ms");
    assertThat(browser.waitFor("#charts [role=img]").getDomAttribute("aria-label"))
        .startsWith("level of lamp A1");
  }

  @Test
  void aTimeOfWhichNothingIsRememberedSaysSo() {
    browser.go(home.uri() + "/#view=members&at=2020-01-01T00:00:00Z");

    browser.waitForText("#time-problem", "Nothing is remembered of 2020-01-01T00:00:00Z");
    assertThat(browser.text("#member-list")).as("not what is so now").doesNotContain("lamp");
  }

  /** No later picture is needed: no part shows what is so now while another says that it is not. */
  @Test
  void allPartsGoToAnotherTimeInOnePicture() {
    browser.go(home.uri() + "/#view=members");
    browser.waitForText("#member-list", "lamp");
    browser.run(
        """
        window.requestAnimationFrame = () => 0;
        location.hash = "view=members&at=2020-01-01T00:00:00Z";
        """);

    browser.waitForText("#time-problem", "Nothing is remembered of 2020-01-01T00:00:00Z");

    assertThat(browser.text("#member-list")).doesNotContain("lamp");
  }

  /** A page that stays open all day does not keep what happened on it. */
  @Test
  void whatHappenedIsAskedForOnceSomebodyLooksAtIt() {
    String asked = "performance.getEntriesByType('resource').map(one => one.name).join(' ')";
    browser.go(home.uri() + "/#view=goals");
    browser.waitForSaid(asked, "/api/v1/history");
    assertThat(String.valueOf(browser.run("return " + asked))).doesNotContain("history/events");

    browser.click("[data-view=history]");

    browser.waitForText("#detail", "stated");
    browser.waitForSaid(asked, "history/events");
  }

  /** Contrast, labels, roles: as the rules of the trade have them, in light and dark. */
  @Test
  void lookingBackIsForEverybody() throws IOException {
    browser.go(home.uri() + "/#view=history");
    browser.waitForText("#detail", "stated");
    browser.waitForText("#charts .legend", "reached or held");
    click("stated");
    browser.waitForText("#time.past #time-told", "As of ");
    for (int width : List.of(1440, 390)) {
      browser.size(width, width == 390 ? 844 : 900);
      for (String theme : List.of("light", "dark")) {
        browser.theme(theme);
        assertThat(Accessibility.faults(browser)).as("%s, %d", theme, width).isEmpty();
        assertThat(browser.run("return document.documentElement.scrollWidth <= innerWidth"))
            .as("nothing is cut off at %d", width)
            .isEqualTo(true);
      }
    }
    browser.size(1440, 900);
  }
}
