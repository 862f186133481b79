package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.stream.StreamSupport;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.rats.broker.EmbeddedBroker;

/**
 * The page of states turns within the time that it states itself (ADE, status derived from
 * heartbeats; A34): the process of a container is killed, or frozen, or the broker goes.
 */
@Isolated("its time is wall time, which others beside it would take")
class StatesPageTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);

  /** Notes in the page when something is there first, as its own clock has it. */
  private static final String WATCH =
      """
      const [selector, text] = arguments;
      window.turned = null;
      const look = () => {
        const found = [...document.querySelectorAll(selector)].find((one) => one.textContent.includes(text));
        if (found && window.turned === null) { window.turned = Date.now(); }
      };
      new MutationObserver(look).observe(document.body, { childList: true, subtree: true, attributes: true });
      look();
      """;

  private static EmbeddedBroker broker;
  private static ServedHome home;
  private static Browser browser;

  @BeforeAll
  static void open() {
    assumeTrue(
        Browser.isThere(),
        "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.");
    broker = EmbeddedBroker.start();
    home = ServedHome.startForOthers(broker.uri());
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
    if (broker != null) {
      broker.close();
    }
  }

  private static ContainerProcess robots() throws Exception {
    ContainerProcess process = ContainerProcess.start(home.site().platform().port(), "robots");
    Awaitility.await()
        .atMost(LIMIT)
        .until(() -> isThere("containers", "container", "robots", "process " + process.pid()));
    Awaitility.await().atMost(LIMIT).until(() -> isThere("members", "member", "rose", "\"well\""));
    return process;
  }

  /** Whether a row of the answer has a text in it, and is not lost. */
  private static boolean isThere(String rows, String name, String value, String text)
      throws Exception {
    JsonNode all = home.get("/states").document().path(rows);
    return StreamSupport.stream(all.spliterator(), false)
        .filter(row -> row.path(name).asText().equals(value))
        .map(JsonNode::toString)
        .anyMatch(row -> row.contains(text) && !row.contains("\"lost\""));
  }

  /** The bound T; longer where all have been slow. */
  private static double bound() throws Exception {
    return home.get("/states").document().at("/timing/shown_within_s").asDouble();
  }

  /** Waits until the page has turned, and returns after how many seconds it had. */
  private static double turned(long since) {
    Awaitility.await().atMost(LIMIT).until(() -> browser.run("return window.turned") != null);
    return (((Number) browser.run("return window.turned")).longValue() - since) / 1000.0;
  }

  @Test
  void whenAProcessIsKilledThePageTurnsRedWithTheReason() throws Exception {
    browser.go(home.uri() + "/#view=states");
    try (ContainerProcess robots = robots()) {
      String process = "process " + robots.pid();
      browser.waitForText("#states [data-name=robots][data-state=well]", process);
      browser.waitForText("#states-bound", "within T = " + bound() + " s");
      browser.run(WATCH, "#states [data-name=robots].bad[data-state=lost]", process);

      double before = bound();
      long killed = System.currentTimeMillis();
      robots.kill();

      assertThat(turned(killed)).isLessThanOrEqualTo(Math.max(before, bound()));
      assertThat(browser.text("#states [data-name=robots][data-state=lost]"))
          .contains("Its process has ended, was killed, or cannot be reached");
      browser.waitForText("#states [data-name=rose][data-state=well]", "rose");
      browser.click("#alerts-open");
      browser.waitForText("#alerts", "robots is lost: Its process has ended");
    }
  }

  @Test
  void whenAProcessFreezesWhatDependsOnItIsDoubtedAndOutOfReach() throws Exception {
    browser.go(home.uri() + "/#view=states");
    try (ContainerProcess robots = robots()) {
      browser.waitForText("#states [data-name=robots][data-state=well]", "process " + robots.pid());
      browser.run(WATCH, "#states [data-name=rose][data-state=unreachable]", "rose");

      double before = bound();
      long frozen = System.currentTimeMillis();
      robots.freeze();

      double after = turned(frozen);
      String told = browser.text("#states .standing:not(.good)");
      assertThat(after).isLessThanOrEqualTo(Math.max(before, bound()));
      assertThat(told)
          .contains("It has given no sign of life for 2 s or longer")
          .contains("Its container robots is doubtful.")
          .contains("Its agent rose is doubtful: Its container robots is doubtful.");
    }
    browser.waitForText("#states [data-name=rose][data-state=well]", "rose");
  }

  @Test
  void whatIsToldIsAsTheDocumentSaysAndReachesWhoListens() throws Exception {
    ServedHome.Answer answer = home.get("/states");

    home.assertValid(answer.document(), "states");
    assertThat(answer.document().findValuesAsText("container"))
        .contains("Main-Container", "lights");
    assertThat(answer.document().findValuesAsText("agent")).contains("CCA", "rose");
    assertThat(answer.document().at("/parts/1/state").asText()).isEqualTo("off");
    browser.go(home.uri() + "/#view=states");
    Accessibility.assertForEverybody(browser, "#states", "depends on the agent rose");
  }

  @Test
  void withoutABrokerNoMemberIsReached() {
    browser.go(home.uri() + "/#view=states");
    browser.waitForText("#states [data-name=bus][data-state=well]", "Bus");
    int port = broker.uri().getPort();
    broker.close();
    try {
      browser.waitForText("#states [data-name=bus][data-state=lost]", "no connection to the bus");
      browser.waitForText(
          "#states [data-name=lamp-a1][data-state=unreachable]", "no connection to the bus");
    } finally {
      broker = EmbeddedBroker.start(port);
    }
    browser.waitForText("#states [data-name=lamp-a1][data-state=well]", "lamp-a1");
  }
}
