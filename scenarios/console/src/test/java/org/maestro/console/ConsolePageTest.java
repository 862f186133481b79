package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.openqa.selenium.Keys;
import org.openqa.selenium.WebElement;

/** The page as a person uses it, in a real browser. */
@Isolated("its time is wall time, which others beside it would take")
class ConsolePageTest {
  private static ServedHome home;
  private static Browser browser;

  @BeforeAll
  static void open() {
    assumeTrue(
        Browser.isThere(),
        "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.");
    home = ServedHome.start();
    browser = Browser.open();
    browser.size(1440, 900);
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
  void theCupIsSentForAndFollowed() {
    browser.complaints();
    browser.go(home.uri() + "/");
    browser.waitForText("#plan", "room A");

    browser.waitFor("#goal-input").sendKeys("(nextTo Cup Bob)", Keys.ENTER);

    browser.waitForText("#detail h2", "(nextTo Cup Bob)");
    assertThat(browser.address()).contains("goal=G");
    browser.waitForText("#detail .story", "Plan 1");
    browser.waitForText("#detail .story", "Reached.");
    browser.waitForText("#goal-list", "achieved");
    browser.waitFor("#plan [data-thing=Cup]");
    browser.waitForText("#plan .light", "lux");

    browser.click("#plan [data-thing=Cup]");
    browser.waitForText("#detail", "(in Cup zone-a)");
    assertThat(browser.address()).contains("thing=Cup");
    assertThat(browser.complaints()).isEmpty();
  }

  @Test
  void whatIsWrittenWronglyIsToldBesideIt() {
    browser.go(home.uri() + "/#view=goals");
    WebElement entry = browser.waitFor("#goal-input");

    entry.sendKeys("(canSe ?who Bob)", Keys.ENTER);

    browser.waitForText("#goal-problem", "write canSee, if that is meant");
    assertThat(entry.getDomProperty("value")).isEqualTo("(canSe ?who Bob)");
  }

  @Test
  void wordsAreOfferedAsTheyAreWritten() {
    browser.go(home.uri() + "/#view=goals");
    browser.runAsync(
        "const done = arguments[0]; const look = () => fetch('/api/v1/words').then(done); look();");
    WebElement entry = browser.waitFor("#goal-input");

    entry.sendKeys("(nextT");
    browser.waitForText("#suggestions", "(nextTo");
    entry.sendKeys(Keys.ARROW_DOWN, Keys.ENTER);

    assertThat(entry.getDomProperty("value")).isEqualTo("(nextTo");
    assertThat(browser.waitFor("#suggestions").isDisplayed()).isFalse();
    entry.clear();
  }

  @Test
  void allIsBroughtToASafeStateByOneClick() {
    browser.go(home.uri() + "/#view=members");
    browser.waitForText("#member-list", "lamp-b1");

    browser.click("#stop");

    browser.waitForText("#notice", "Every device was told to go into a safe state.");
    browser.waitForText("#member-list", "safe");
  }

  @Test
  void aPlanIsLookedAtBeforeItIsBegun() {
    browser.go(home.uri() + "/#view=goals");
    WebElement entry = browser.waitFor("#goal-input");
    entry.sendKeys("(canSee ?who Cup)");

    browser.click("#goal-preview");

    browser.waitForText("#goal-plan", "Would cost ");
    browser.waitForText("#goal-plan", "looks for Cup in");
    assertThat(entry.getDomProperty("value")).isEqualTo("(canSee ?who Cup)");
    entry.clear();
  }

  @Test
  void aGoalIsStatedWithItsBenefit() {
    browser.go(home.uri() + "/#view=goals");
    WebElement entry = browser.waitFor("#goal-input");
    entry.sendKeys("(keep (>= (illuminance zone-a) 11))");
    browser.waitFor("#goal-benefit").sendKeys("much", Keys.ENTER);
    browser.waitForText("#goal-problem", "The benefit is no number");

    browser.waitFor("#goal-benefit").clear();
    browser.waitFor("#goal-benefit").sendKeys("(* 2 250)", Keys.ENTER);

    browser.waitFor("#goal-list [title^='u = '][title*='·500 − ']");
    browser.waitForText("#detail", "Cancel goal");
    assertThat(browser.waitFor("#goal-benefit").getDomProperty("value")).isEmpty();
    browser.run(
        "[...document.querySelectorAll('#detail button')]"
            + ".find(button => button.textContent === 'Cancel goal').click()");
    browser.waitForText("#goal-list", "cancelled");
  }

  @Test
  void aGoalIsMadeOfATemplate() {
    browser.go(home.uri() + "/#view=goals");
    browser.waitForText("#goal-template", "nextTo");

    browser.run(
        "const t = document.getElementById('goal-template');"
            + " t.value = '(nextTo Thing Thing)'; t.dispatchEvent(new Event('change'));");

    WebElement entry = browser.waitFor("#goal-input");
    entry.sendKeys("Cup");
    assertThat(entry.getDomProperty("value")).isEqualTo("(nextTo Cup Thing)");
    entry.clear();
  }

  @Test
  void agentsAreMovedAndRemovedAndAddedByTheForm() {
    browser.go(home.uri() + "/#view=members");
    browser.waitForText("#agent-name", "lamp-b3");
    browser.run("document.getElementById('agent-forms').open = true");

    order("agent-move", "Array.from(document.querySelectorAll('#agent-container option')).at(-1)");
    browser.waitForText("#agent-told", "lamp-b3");

    browser.run("document.getElementById('agent-name').value = 'lamp-b3'");
    browser.click("#agent-remove");
    browser.waitForText("#agent-told", "lamp-b3");
    browser.waitForText("#member-list", "lamp-b2");

    browser
        .waitFor("#agent-description")
        .sendKeys(
            """
            @prefix maestro: <https://w3id.org/maestro#> .
            @prefix : <https://w3id.org/maestro/domain#> .
            <#lamp-b3> a :Lamp ; maestro:pose "4.5 1.9 2.8" ;
              maestro:luminousIntensity 471 ; maestro:beamAngle 100 ; :power 27 .
            """);
    browser.click("#agent-add");
    browser.waitForText("#agent-told", "lamp-b3");
    browser.waitForText("#member-list", "lamp-b3");

    browser.waitFor("#agent-description").clear();
    browser
        .waitFor("#agent-description")
        .sendKeys(
            """
            @prefix maestro: <https://w3id.org/maestro#> .
            @prefix : <https://w3id.org/maestro/domain#> .
            @prefix home: <https://w3id.org/maestro/home/bob#> .
            <#door-out> a :DrivenDoor ; maestro:openingFrom "0 1" ; maestro:openingTo "0 1.9" ;
              :side home:zone-a .
            """);
    browser.click("#agent-add");
    browser.waitForText("#agent-told", "door-out");
    browser.waitForText("#member-list", "door-out");

    browser.run("document.getElementById('agent-description').value = 'no Turtle'");
    browser.click("#agent-add");
    browser.waitFor("#agent-told.problem");
  }

  private static void order(String button, String container) {
    browser.run(
        "document.getElementById('agent-name').value = 'lamp-b3';"
            + " document.getElementById('agent-container').value = ("
            + container
            + ").value;");
    browser.click("#" + button);
  }

  @Test
  void whatIsKnownIsAsked() {
    browser.go(home.uri() + "/#view=knowledge");
    browser.waitForText("#fact-list", "(level lamp-a1)");

    browser.waitFor("#question-input").sendKeys("(in rose ?where)", Keys.ENTER);

    browser.waitForText("#answers", "?where = zone-");
    WebElement question = browser.waitFor("#question-input");
    question.clear();
    question.sendKeys(
        "SELECT DISTINCT ?who WHERE { GRAPH ?g { ?o <https://w3id.org/maestro#sourceName> ?who } }",
        Keys.ENTER);
    browser.waitForText("#answers", "lamp-a1");

    browser.waitFor("#fact-list input").sendKeys("(level lamp-a1");
    browser.waitForText("#fact-list [role=status]", "1–1 of 1");
    browser.click("#fact-list tbody tr");
    browser.waitForText("#detail", "✓ now");
    assertThat(browser.address()).contains("fact=");
  }

  @Test
  void longListsAreFilteredSortedAndSaved() {
    browser.go(home.uri() + "/#view=knowledge");
    browser.waitForText("#fact-list", "(level lamp-a1)");

    browser.waitFor("#fact-list input").sendKeys("(level lamp-a");
    browser.waitForText("#fact-list [role=status]", "1–2 of 2");
    browser.click("#fact-list th:first-child button");
    browser.click("#fact-list th:first-child button");

    browser.waitFor("#fact-list th:first-child[aria-sort=descending]");
    assertThat(browser.text("#fact-list tbody tr:first-child")).contains("lamp-a2");
    browser.run(
        "URL.createObjectURL = (file) => { file.text().then((text) => { window.saved = text; }); return '#view=knowledge'; };");
    browser.click("#fact-list .tools button:last-child");
    browser.waitForSaid("window.saved", "\"(level lamp-a2)\"");
    assertThat(browser.run("return window.saved.trim().split('\\n').length")).isEqualTo(3L);
    assertThat(
            browser.runAsync(
                "import('/list.js').then((list) => arguments[1](arguments[0].map(list.quoted).join(' ')))",
                List.of("=1+1", "-2.5", "+\"x\"", "(at 1)")))
        .as("nothing is calculated")
        .isEqualTo("\"'=1+1\" \"-2.5\" \"'+\"\"x\"\"\" \"(at 1)\"");
  }

  /** A browser keeps few connections to one address, for all pages together. */
  @Test
  void aPageThatNobodySeesLeavesItsConnectionToOthers() {
    browser.go(home.uri() + "/#view=goals");

    hide(true);
    browser.waitFor("#link.connecting");
    hide(false);

    browser.waitFor("#link.live");
  }

  @Test
  void aPartThatFailsKeepsNoOtherBack() {
    browser.go(home.uri() + "/#view=goals");
    browser.waitFor("#link.live");

    Object told =
        browser.runAsync(
            """
            const done = arguments[0];
            import("/feed.js").then(({ onChange, changed }) => {
              let told = 0;
              onChange(() => { throw new Error("this part fails"); });
              onChange(() => {
                told += 1;
                if (told === 2) { done(told); } else { changed(); }
              });
              changed();
            });
            """);

    assertThat(told).isEqualTo(2L);
    assertThat(browser.complaints()).anySatisfy(one -> assertThat(one).contains("this part fails"));
    browser.open("about:blank");
  }

  private static void hide(boolean isHidden) {
    browser.run(
        "Object.defineProperty(document, 'hidden', { configurable: true, value: arguments[0] });"
            + " document.dispatchEvent(new Event('visibilitychange'));",
        isHidden);
  }

  /** Contrast, labels, roles: as the rules of the trade have them, in light and dark. */
  @Test
  void eachViewIsForEverybody() throws IOException {
    browser.go(home.uri() + "/");
    browser.waitForText("#plan", "room A");
    for (String view : List.of("goals", "members&thing=rose", "knowledge")) {
      browser.view(view);
      for (int width : List.of(1440, 900, 390)) {
        browser.size(width, width == 390 ? 844 : 900);
        for (String theme : List.of("light", "dark")) {
          browser.theme(theme);
          assertThat(Accessibility.faults(browser)).as("%s, %d, %s", theme, width, view).isEmpty();
          assertThat(browser.run("return document.documentElement.scrollWidth <= innerWidth"))
              .as("nothing is cut off at %d", width)
              .isEqualTo(true);
        }
      }
    }
    browser.size(1440, 900);
    browser.go(home.uri() + "/");
    assertThat(browser.run("return document.documentElement.scrollHeight <= innerHeight"))
        .as("one screen without scrolling")
        .isEqualTo(true);
  }
}
