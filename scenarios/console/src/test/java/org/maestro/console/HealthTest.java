package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.http.HttpResponse;
import java.time.Duration;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.console.client.HttpQuestions;
import org.maestro.rats.broker.EmbeddedBroker;

/** Who watches over processes is told how this one does, and why it is of no use now. */
@Isolated("its time is wall time, which others beside it would take")
class HealthTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static EmbeddedBroker broker;
  private static ServedHome home;

  @BeforeAll
  static void start() {
    broker = EmbeddedBroker.start();
    home = ServedHome.startOn(broker.uri());
  }

  @AfterAll
  static void end() {
    home.close();
    broker.close();
  }

  private static HttpResponse<String> becomes(String path, int status) {
    return Awaitility.await()
        .atMost(LIMIT)
        .until(() -> home.whole(path), answer -> answer.statusCode() == status);
  }

  @Test
  void itIsReadyWhileGoalsAreTakenAndSaysWhyWhenTheyAreNot() throws Exception {
    String health =
        Awaitility.await()
            .atMost(LIMIT)
            .until(() -> home.whole("/health").body(), body -> body.contains("lights"));
    assertThat(health)
        .contains("\"status\":\"well\",\"reasons\":[]")
        .contains("{\"container\":\"lights\",\"condition\":\"alive\"}");
    assertThat(becomes("/ready", 200).body()).isEqualTo("{\"ready\":true,\"reasons\":[]}");

    home.site().platform().endAgent("CCA");
    assertThat(becomes("/ready", 503).body())
        .contains("There is no central coordination agent (CCA) now");
    new HttpQuestions(home.uri()).revive().join();
    becomes("/ready", 200);
  }

  @Test
  void withoutABrokerItIsNotReadyAndThePageSaysSo() throws Exception {
    becomes("/ready", 200);
    int port = broker.uri().getPort();

    broker.close();

    assertThat(becomes("/ready", 503).body()).contains("There is no connection to the bus (");
    HttpResponse<String> health = home.whole("/health");
    assertThat(health.statusCode()).as("the process is there").isEqualTo(200);
    assertThat(health.body())
        .contains("\"status\":\"impaired\"", "There is no connection to the bus (");
    try {
      assumeTrue(
          Browser.isThere(),
          "The page is not tried: there is no chromium with its chromedriver; .ci/install installs them.");
      try (Browser browser = Browser.open()) {
        browser.size(1440, 900);
        browser.go(home.uri() + "/");
        browser.waitFor("#alerts-open:not([hidden])");
        browser.click("#alerts-open");
        browser.waitForText("#alerts", "There is no connection to the bus");
      }
    } finally {
      broker = EmbeddedBroker.start(port);
    }
    assertThat(becomes("/ready", 200).body()).isEqualTo("{\"ready\":true,\"reasons\":[]}");
  }

  @Test
  void whoGathersFiguresIsToldWhatHappensHere() throws Exception {
    home.state("(>= (illuminance zone-a) 40)");

    assertThat(
            Awaitility.await()
                .atMost(LIMIT)
                .until(
                    () -> home.whole("/metrics").body(),
                    figures -> figures.contains("maestro_goals{state=\"achieved\"}")))
        .contains("maestro_members{phase=\"ready\"} ")
        .contains("maestro_containers{condition=\"alive\"} ")
        .contains("maestro_story_entries_total{kind=\"goal\"} ")
        .contains("maestro_goal_duration_seconds_count ")
        .contains("maestro_console_requests_seconds_count{operation=\"stateGoal\",status=\"201\"}")
        .contains("jvm_memory_used_bytes{area=\"heap\"");
  }
}
