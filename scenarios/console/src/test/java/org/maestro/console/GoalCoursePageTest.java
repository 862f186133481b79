package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.openqa.selenium.Keys;

/** A goal's plans, time line and bids, as a person looks at them in a real browser. */
@Isolated("its time is wall time, which others beside it would take")
class GoalCoursePageTest {
  /** Twenty robots with two steps each; some are over, some under way, some still to come. */
  private static final String LARGE_PLAN =
      """
      const steps = Array.from({ length: 40 }, (_, i) => {
        const number = i + 1;
        const state = number < 12 ? "done" : number < 16 ? "under-way" : "waiting";
        return { number, text: `robot ${i % 20} carries box ${number}`, member: `robot-${i % 20}`, feature: "carry",
          after: [...(number > 20 ? [number - 20] : []), ...(number % 4 === 0 ? [number - 1] : [])], cost: 1, duration_s: 5,
          start_s: i, state, begun_s: state === "waiting" ? null : 100 + i, ended_s: state === "done" ? 105 + i : null, problem: null };
      });
      const plan = { number: 1, cause: null, asked_s: 99, made_s: 100, purpose: "reach", cost: 40, duration_s: 45, not_asked: 0, steps };
      const looks = { chosen: null, time: 115, goesOn: true, choose: () => {} };
      const done = arguments[0];
      """;

  private static ServedHome home;
  private static Browser browser;
  private static String goal;

  @BeforeAll
  static void open() throws Exception {
    assumeTrue(
        Browser.isThere(),
        "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.");
    home = ServedHome.start();
    browser = Browser.open();
    browser.size(1440, 900);
    goal = home.state("(nextTo Cup Bob)");
    browser.go(address("plan"));
    browser.waitForText("#detail h2", "achieved");
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

  private static String address(String shown) {
    return home.uri() + "/#view=goals&goal=" + goal + "&show=" + shown;
  }

  @Test
  void aPlanIsAGraphOfWhichEachStepTellsWhy() {
    browser.complaints();
    browser.go(address("plan"));
    browser.waitForText("#detail .about", "because ");
    browser.waitForText("#detail .picture", "rose");
    assertThat(browser.text("#detail .step.good .standing")).contains("done after");

    // The last plan may have one step only, where what came between was slow.
    choosePlan(1);
    browser.waitForText("#detail .picture", "dropped");
    browser.waitFor("#detail .step[tabindex='0']").sendKeys(Keys.ENTER);
    browser.waitForText("#detail .aside", "It costs ");
    assertThat(browser.address()).contains("plan=1").contains("step=");
    String first = browser.text("#detail .aside h3");
    browser.waitFor("#detail .step.chosen").sendKeys(Keys.ARROW_RIGHT);
    browser.waitFor("#detail .step.chosen:focus");
    Awaitility.await()
        .atMost(Duration.ofSeconds(30))
        .until(() -> !browser.text("#detail .aside h3").equals(first));

    choosePlan(2);
    assertThat(browser.address()).contains("plan=2").doesNotContain("step=");
    assertThat(browser.complaints()).isEmpty();
  }

  private static void choosePlan(int number) {
    browser.run(
        "const plans = document.getElementById('course-plan');"
            + " plans.value = '%d'; plans.dispatchEvent(new Event('change'));".formatted(number));
    browser.waitForText("#detail .about", "Plan " + number);
  }

  @Test
  void whereSomethingElseIsLookedAtItStaysAway() {
    browser.go(address("plan"));
    browser.waitFor("#detail .picture .step");

    browser.click("[data-view=history]");

    browser.waitFor("main[data-view=history]:not([data-wide])");
    browser.run("dispatchEvent(new Event('resize'))");
    assertThat(browser.text("#detail .course")).isEmpty();
  }

  @Test
  void whatEachDidStandsOnATimeLine() {
    browser.go(address("time"));
    browser.waitForText("#detail .names", "rose");
    browser.waitForText("#detail .heads", "plan 1");
    browser.waitFor("#detail .step.good .bar");

    browser.click("#detail .step.good:last-of-type");

    browser.waitForText("#detail .aside", "Why this one and not another");
    assertThat(browser.address()).contains("step=").contains("plan=");
  }

  @Test
  void whoWasAskedIsListedWithWhoWasChosen() {
    browser.go(address("bids") + "&plan=1");
    browser.waitForText("#detail table", "✓ chosen");

    browser.waitFor("#detail .tools input").sendKeys("rose picks up");
    browser.waitForText("#detail [role=status]", "of 1");
    assertThat(browser.text("#detail tbody tr")).contains("rose", "✓ chosen");
    browser.click("#detail tbody tr");

    browser.waitFor("#detail tr.chosen");
    assertThat(browser.address()).contains("step=");
  }

  @Test
  void aLargePlanIsDrawnWithoutStepsInEachOthersPlace() {
    browser.go(address("plan"));

    Object covered =
        browser.runAsync(
            LARGE_PLAN
                + """
                import('/graph.js').then(({ graph }) => {
                  const drawn = graph(plan, looks);
                  const places = [...drawn.querySelectorAll('.step')].map(g => /translate\\((\\S+) (\\S+)\\)/.exec(g.getAttribute('transform')).slice(1).map(Number));
                  const box = drawn.querySelector('.box');
                  const [width, height] = ['width', 'height'].map(name => Number(box.getAttribute(name)));
                  done([places.length, places.filter(([x, y], i) => places.some(([u, v], j) => i < j && Math.abs(x - u) < width && Math.abs(y - v) < height)).length].join());
                });
                """);

    assertThat(covered).isEqualTo("40,0");
  }

  @Test
  void onALongTimeLineEachMemberHasARowAndWhatIsToComeIsHatched() {
    browser.go(address("time"));

    Object drawn =
        browser.runAsync(
            LARGE_PLAN
                + """
                import('/timeline.js').then(({ timeline }) => {
                  const parts = document.createElement('div');
                  parts.append(...timeline([plan], 900, looks));
                  const hatched = [...parts.querySelectorAll('.step .planned')].length;
                  done([parts.querySelectorAll('.rows .names text').length, hatched, parts.querySelectorAll('.rows line.now').length].join());
                });
                """);

    assertThat(drawn).isEqualTo("20,25,1");
  }

  /** Contrast, labels, roles; and what is long is scrolled within. */
  @Test
  void eachPartIsForEverybody() throws IOException {
    for (String shown : List.of("plan&plan=1&step=1", "time", "bids")) {
      see("light", 1440, 900, shown);
      assertThat(browser.run("return document.documentElement.scrollHeight <= innerHeight"))
          .as("one screen without scrolling")
          .isEqualTo(true);
      see("dark", 390, 844, shown);
    }
    browser.theme("light");
    browser.size(1440, 900);
  }

  private static void see(String theme, int width, int height, String shown) throws IOException {
    browser.size(width, height);
    browser.go(address(shown));
    browser.theme(theme);
    browser.waitFor("#detail .body > .picture > *, #detail .body table");
    assertThat(Accessibility.faults(browser)).as("%s, %d, %s", theme, width, shown).isEmpty();
    assertThat(browser.run("return document.documentElement.scrollWidth <= innerWidth"))
        .as("nothing is cut off at %d", width)
        .isEqualTo(true);
  }
}
