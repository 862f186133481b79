package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.List;
import java.util.stream.StreamSupport;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

/** The plans of a goal and what was answered for them, as a running platform tells them. */
@Isolated("its time is wall time, which others beside it would take")
class PlansOfConsoleTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static ServedHome home;
  private static String goal;

  @BeforeAll
  static void aCupIsBrought() throws Exception {
    home = ServedHome.start();
    goal = home.state("(nextTo Cup Bob)");
    Awaitility.await()
        .atMost(LIMIT)
        .until(
            () -> home.get("/goals").document().at("/goals/0/state").asText().equals("achieved"));
  }

  @AfterAll
  static void stop() {
    home.close();
  }

  private static List<JsonNode> all(JsonNode array) {
    return StreamSupport.stream(array.spliterator(), false).toList();
  }

  @Test
  void plansAreToldWithTheirCausesAndTheirSteps() throws Exception {
    JsonNode document = home.get("/goals/" + goal + "/plans").document();

    home.assertValid(document, "plans");
    List<JsonNode> plans = all(document.path("plans"));
    assertThat(plans).hasSizeGreaterThan(1);
    assertThat(plans.get(0).path("cause").isNull()).isTrue();
    assertThat(plans.get(1).path("cause").asText()).isNotEmpty();
    List<JsonNode> steps =
        plans.stream().flatMap(plan -> all(plan.path("steps")).stream()).toList();
    assertThat(steps).extracting(step -> step.path("member").asText()).contains("rose");
    assertThat(steps)
        .filteredOn(step -> step.path("text").asText().equals("rose places Cup at Bob"))
        .extracting(step -> step.path("state").asText())
        .contains("done");
    assertThat(steps)
        .filteredOn(step -> step.path("state").asText().equals("done"))
        .allMatch(step -> step.path("begun_s").asDouble() <= step.path("ended_s").asDouble())
        .allMatch(step -> step.path("ended_s").asDouble() <= document.path("now_s").asDouble());
  }

  @Test
  void whoWasAskedIsToldWithWhoWasChosen() throws Exception {
    JsonNode document = home.get("/goals/" + goal + "/bids?plan=1").document();

    home.assertValid(document, "bids");
    JsonNode plan = home.get("/goals/" + goal + "/plans").document().at("/plans/0");
    for (JsonNode step : plan.path("steps")) {
      assertThat(all(document.path("bids")))
          .filteredOn(
              bid ->
                  bid.path("step").asInt() == step.path("number").asInt()
                      && bid.path("chosen").asBoolean())
          .extracting(bid -> bid.path("member").asText())
          .containsExactly(step.path("member").asText());
    }
    home.assertValid(home.get("/goals/" + goal + "/bids").document(), "bids");
  }

  @Test
  void whatThereIsNotIsToldAsSuch() throws Exception {
    assertThat(home.get("/goals/G99/plans").problem()).contains("There is no goal G99");
    assertThat(home.get("/goals/G99/bids").problem()).contains("There is no goal G99");
    assertThat(home.get("/goals/" + goal + "/bids?plan=99").problem())
        .contains("plan 99 is not")
        .contains("Of " + goal + " these plans are kept: 1");
    assertThat(home.get("/goals/" + goal + "/bids?plan=one").problem())
        .isEqualTo("plan is a whole number, not \"one\".");
  }
}
