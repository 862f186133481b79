package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

/** What is known of persons is asked for on the page (ADE, 4.1; A57). */
@Isolated("its time is wall time, which others beside it would take")
class PersonsPageTest {
  private static final String NO_BROWSER =
      "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.";
  private static final String OF_BOB =
      """

      home:glasses a :Cue ; rdfs:label "wears glasses"@en .
      home:Bob :looksLike home:glasses .
      home:Opera a :Show ; rdfs:label "the opera"@en .
      home:evenings a :Preference ; rdfs:label "what Bob likes in the evening"@en ;
        :preferenceOf home:Bob ; :preferenceAbout "TV show" ; :prefers home:Opera ;
        :fromMinute 1080 ; :untilMinute 1440 .
      home:visited a maestro:Fluent ; rdfs:label "visited"@en ;
        maestro:arguments ( "?who - Person" "?zone - Zone" ) ; maestro:countedWhen "(in ?who ?zone)" .
      """;

  @Test
  void preferencesCuesAndHabitsAreToldWithSourceAndAge() throws Exception {
    try (ServedHome home = ServedHome.startWithMore(OF_BOB)) {
      home.state("(canSee ?who Bob)");
      assumeTrue(Browser.isThere(), NO_BROWSER);
      try (Browser browser = Browser.open()) {
        browser.size(1440, 900);
        browser.complaints();
        browser.go(home.uri() + "/#view=knowledge");

        ask(browser, "(and (preferenceOf ?p Bob) (prefers ?p ?show))");
        browser.waitForText("#answers", "?show = Opera");
        browser.waitForText("#answers", "since the platform began");

        ask(browser, "(looksLike Bob ?cue)");
        browser.waitForText("#answers", "?cue = glasses");

        browser.waitForText("#fact-list", "(visited Bob zone-a)");
        ask(browser, "(= (visited Bob zone-a) ?times)");
        browser.waitForText("#answers", "?times = 1");
        browser.waitForText("#answers", "habits");
        assertThat(browser.complaints()).isEmpty();
      }
    }
  }

  private static void ask(Browser browser, String question) {
    WebElement input = browser.waitFor("#question-input");
    input.clear();
    input.sendKeys(question, Keys.ENTER);
  }
}
