package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** What commands print of a platform with {@code --json} is as its schema says. */
@Isolated("its time is wall time, which others beside it would take")
class JsonOfPlatformTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);

  @TempDir private Path directory;

  @Test
  void whatAPlatformTellsIsData() throws Exception {
    try (JavaProcess platform = maestro("run", "bob", "--port", "0", "--speed", "20")) {
      Awaitility.await()
          .atMost(LIMIT)
          .until(() -> platform.output().contains(" runs: ") || !platform.isAlive());

      JsonNode unknown = document("know", 0, "know", "(position Cup ?at)").at("/answers/0");
      assertThat(unknown.path("truth").asText()).isEqualTo("unknown");
      assertThat(unknown.path("confidence").isNull()).isTrue();
      JsonNode reached = document("goal", 0, "goal", "(canSee ?who Bob)");
      assertThat(reached.path("simulated_s").isNumber()).isTrue();
      assertThat(reached.at("/binding/who").asText()).startsWith("cam-");
      JsonNode held =
          document(
              "goal",
              0,
              "goal",
              "(keep (>= (illuminance zone-a) 10))",
              "--benefit",
              "(* 2 30)",
              "--allowed",
              "600",
              "--urgency",
              "1..5");
      assertThat(held.path("held").asBoolean()).isTrue();
      assertThat(held.path("calls").isNull()).isTrue();
      JsonNode goals = document("goals", 0, "goals").path("goals");
      assertThat(goals.findValuesAsText("state")).containsExactly("achieved", "holding");
      assertThat(goals.at("/1/age_s").isNumber()).isTrue();
      assertThat(goals.at("/1/deadline_s").isNull()).isTrue();
      assertThat(goals.at("/1/worth/benefit").asDouble()).isEqualTo(60);
      assertThat(goals.at("/1/worth/allowed_s").asDouble()).isEqualTo(600);
      assertThat(goals.at("/1/worth/urgency_to").asDouble()).isEqualTo(5);

      JsonNode seen = document("know", 0, "know", "(position rose ?at)").at("/answers/0");
      assertThat(seen.at("/binding/at").isArray()).isTrue();
      assertThat(seen.at("/binding/at")).hasSize(3).allMatch(coordinate -> coordinate.isNumber());
      assertThat(seen.at("/because/0/kind").asText()).isEqualTo("stated");
      JsonNode light = document("know", 0, "know", "(illuminance zone-a)");
      assertThat(light.at("/answers/0/binding/value").isNumber()).isTrue();

      JsonNode agents = document("agents", 0, "agents").path("agents");
      assertThat(agents.findValuesAsText("agent")).contains("rose", "CCA");
      assertThat(agents.at("/0/age_s").isNumber()).isTrue();
      assertThat(words(agents, "rose", "disabled")).containsExactly("place");
      assertThat(words(agents, "rose", "drivers")).containsExactly("mobile-robot");
      assertThat(
              document("agents-containers", 0, "agents", "--containers")
                  .path("containers")
                  .findValuesAsText("container"))
          .contains("Main-Container", "robots");
      assertThat(
              document("agents-diagram", 0, "agents", "--diagram")
                  .path("references")
                  .findValuesAsText("to"))
          .contains("rose/navigation", "cam-a/perception", "CCA/cognition");
      assertThat(document("why", 0, "why", "G1").path("story").findValuesAsText("kind"))
          .contains("goal", "plan", "end");
      assertThat(document("trace", 0, "trace", "G1").path("trace").findValuesAsText("layer"))
          .contains("story", "agents", "bus");
      JsonNode day = document("day", 0, "day", "Bob");
      assertThat(day.at("/requests/0/goal").asText()).isEqualTo("(canSee ?who Bob)");
      assertThat(day.at("/requests/0/end").asText()).isEqualTo("reached");
      assertThat(day.path("told").findValuesAsText("text"))
          .anyMatch(text -> text.startsWith("Somebody asks me to "));
      assertThat(document("words", 0, "words").path("words").findValuesAsText("unit"))
          .contains("lux");
    }
  }

  private static List<String> words(JsonNode agents, String agent, String name) {
    List<String> words = new ArrayList<>();
    agents.forEach(
        row -> {
          if (row.path("agent").asText().equals(agent)) {
            row.path(name).forEach(word -> words.add(word.asText()));
          }
        });
    return words;
  }

  @Test
  void aDemoTellsItsTimes() throws Exception {
    JsonNode demo = document("demo", 0, "demo", "bob-lit", "--speed", "50");
    assertThat(demo.path("simulated_s").asDouble())
        .isGreaterThanOrEqualTo(demo.path("lower_bound_s").asDouble());
  }

  private JsonNode document(String schema, int exitCode, String... arguments) throws Exception {
    List<String> all = new ArrayList<>(List.of(arguments));
    all.add("--json");
    try (JavaProcess process = maestro(all.toArray(String[]::new))) {
      JavaProcess.Ended ended = process.await(LIMIT);
      assertThat(ended.exitCode()).as(ended.output() + ended.errors()).isEqualTo(exitCode);
      return CommandSchemas.valid(schema, ended.output());
    }
  }

  private JavaProcess maestro(String... arguments) throws IOException {
    return JavaProcess.start(
        Maestro.class.getName(),
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }
}
