package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicReference;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** What was shown is told again as it was, also after a restart. */
@Isolated("its time is wall time, which others beside it would take")
class PastOfConsoleTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final List<String> PARTS = List.of("facts", "goals", "agents");

  @TempDir private Path data;

  @Test
  void whatWasShownIsToldAgain() throws Exception {
    List<Set<JsonNode>> shown = new ArrayList<>();
    Instant then;
    try (ServedHome home = ServedHome.startWith(data)) {
      String first = home.state("(canSee ?who Bob)");
      await(() -> state(home, first).equals("achieved"));
      then = momentWithoutNews(home, shown);

      String second = home.state("(in rose zone-a)");
      await(() -> state(home, second).equals("achieved"));

      assertThat(live(home)).isNotEqualTo(shown);
      assertThat(told(home, then)).isEqualTo(shown);
      JsonNode state = home.get("/history/state?at=" + then).document();
      home.assertValid(state, "past-state");
      assertThat(state.path("recorded").asBoolean()).isTrue();
      assertThat(state.at("/home")).isEqualTo(home.get("/home").document());
      JsonNode kept = home.get("/history").document();
      home.assertValid(kept, "past");
      assertThat(kept.path("problem").isNull()).isTrue();
      await(
          () ->
              happened(home, home.get("/history").document())
                  .containsAll(List.of(first + " stated", second + " reached")));
      assertThat(happened(home, home.get("/history").document()))
          .contains("rose joined", second + " begun");
      assertLightIsCharted(home, kept);
    }
    try (ServedHome home = ServedHome.startWith(data)) {
      await(() -> told(home, Instant.now()).equals(live(home)));

      assertThat(told(home, then)).as("after a restart").isEqualTo(shown);
      assertThat(happened(home, home.get("/history").document())).contains("G1 reached");
    }
  }

  /**
   * A moment of which is told what was shown just before it: nothing has changed between the two.
   *
   * @param shown becomes what was shown
   */
  private static Instant momentWithoutNews(ServedHome home, List<Set<JsonNode>> shown) {
    AtomicReference<Instant> moment = new AtomicReference<>(Instant.EPOCH);
    await(
        () -> {
          shown.clear();
          shown.addAll(live(home));
          moment.set(Instant.now());
          await(() -> shown(home).isAfter(moment.get()));
          return told(home, moment.get()).equals(shown);
        });
    return moment.get();
  }

  private static Instant shown(ServedHome home) throws Exception {
    return Instant.parse(home.get("/history").document().path("to").asText());
  }

  private static void assertLightIsCharted(ServedHome home, JsonNode kept) throws Exception {
    Instant from = Instant.parse(kept.path("from").asText());
    String light = "(illuminance zone-a)";
    assertThat(kept.path("series")).extracting(JsonNode::asText).contains(light);
    JsonNode samples =
        home.get(
                "/history/samples?points=10&from=%s&to=%s&series=%s"
                    .formatted(
                        from.minusSeconds(60),
                        kept.path("now").asText(),
                        URLEncoder.encode(light + ",nobody", StandardCharsets.UTF_8)))
            .document();
    home.assertValid(samples, "past-samples");
    assertThat(samples.at("/series/0/mean/0").isNull()).as("before the begin").isTrue();
    assertThat(samples.at("/series/0/mean/9").asDouble())
        .isPositive()
        .isBetween(
            samples.at("/series/0/low/9").asDouble(), samples.at("/series/0/high/9").asDouble());
    assertThat(samples.at("/series/1/mean")).allMatch(JsonNode::isNull);
  }

  private static List<String> happened(ServedHome home, JsonNode kept) throws Exception {
    JsonNode document =
        home.get(
                "/history/events?from=%s&to=%s"
                    .formatted(kept.path("from").asText(), kept.path("now").asText()))
            .document();
    home.assertValid(document, "past-events");
    List<String> all = new ArrayList<>();
    document
        .path("events")
        .forEach(event -> all.add(event.path("name").asText() + " " + event.path("what").asText()));
    return all;
  }

  private static String state(ServedHome home, String goal) throws Exception {
    for (JsonNode row : home.get("/goals").document().path("goals")) {
      if (row.path("id").asText().equals(goal)) {
        return row.path("state").asText();
      }
    }
    return "";
  }

  /** All that the page shows now. */
  private static List<Set<JsonNode>> live(ServedHome home) throws Exception {
    List<Set<JsonNode>> all = new ArrayList<>();
    for (String part : PARTS) {
      all.add(rows(home.get("/" + part).document().path(part)));
    }
    return all;
  }

  private static List<Set<JsonNode>> told(ServedHome home, Instant at) throws Exception {
    JsonNode state = home.get("/history/state?at=" + at).document();
    return PARTS.stream().map(part -> rows(state.path(part))).toList();
  }

  /** Ages go on. */
  private static Set<JsonNode> rows(JsonNode rows) {
    Set<JsonNode> all = new HashSet<>();
    for (JsonNode row : rows) {
      ObjectNode copy = row.deepCopy();
      copy.remove("age_s");
      all.add(copy);
    }
    return all;
  }

  @Test
  void whatCannotBeAnsweredIsASentence() throws Exception {
    Map<String, String> problems =
        Map.of(
            "/history/state", "The parameter at is missing.",
            "/history/state?at=noon", "at is an instant such as",
            "/history/state?at=%2B1000000000-12-31T00:00:00Z", "at is an instant such as",
            "/history/state?at=2020-01-01T00:00:00Z", "Nothing is remembered of 2020-01-01T00:00",
            "/history/events?from=2020-01-01T00:00:00Z&to=2020-01-01T00:00:00Z", "to has to be",
            "/history/samples?series=x&from=2020-01-01T00:00:00Z&to=2021-01-01T00:00:00Z&points=0",
                "points is from 1 to 2000, not 0.");
    try (ServedHome home = ServedHome.start()) {
      for (Map.Entry<String, String> each : problems.entrySet()) {
        ServedHome.Answer answer = home.get(each.getKey());
        assertThat(answer.status()).isEqualTo(400);
        assertThat(answer.problem()).contains(each.getValue());
      }
    }
  }

  private static void await(Callable<Boolean> condition) {
    Awaitility.await().atMost(LIMIT).until(condition);
  }
}
