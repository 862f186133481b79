package org.maestro.console.trace;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.console.traffic.CallMessages;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.platform.jade.SentMessage;
import org.maestro.rats.transport.Message;

class TracesTest {
  private Duration now = Duration.ZERO;
  private final CallMessages calls = new CallMessages("home");
  private final Traces traces = new Traces("home", () -> now);

  private void story(String goal, String text) {
    traces.told(new StoryEntry(goal, now, StoryEntry.Kind.STEP, text));
  }

  private void said(String performative, String from, String to, String conversation, String text) {
    traces.sent(
        new SentMessage(
            performative,
            from + "@home",
            to + "@home",
            Optional.of(conversation).filter(id -> !id.isEmpty()),
            Optional.of("fipa-request"),
            text));
  }

  private void heard(String topic, String json) {
    calls
        .read(new Message("rats/1/home/" + topic, json.getBytes(UTF_8), false, Optional.empty()))
        .ifPresent(traces::heard);
  }

  private List<String> trace(String goal) {
    List<String> lines = new ArrayList<>();
    for (JsonNode entry : traces.trace(goal).orElseThrow().path("trace")) {
      int times = entry.path("times").asInt();
      lines.add(
          String.join(
              " ",
              entry.path("layer").asText(),
              entry.path("kind").asText(),
              entry.path("from").asText(),
              entry.path("to").asText(),
              times == 1 ? "" : times + " times until " + entry.path("until_s").asText()));
    }
    return lines.stream().map(String::strip).toList();
  }

  @Test
  void whatIsSaidForAGoalIsFoundInEachLayerByItsId() {
    story("G1", "Step 1 of 1: rose picks Cup.");
    said("cfp", "CCA", "rose", "C-1", "((cost (:goal G1 (nextTo Cup Bob)) (:features pick)))");
    said("propose", "rose", "CCA", "C-1", "((cost (:feature pick) (:price 2)))");
    said("request", "CCA", "rose", "C-2", "((perform (:goal G1) (:call \"CCA-G1-1\")))");
    said("request", "CCA", "rose", "C-3", "((perform (:goal G2) (:call \"CCA-G2-1\")))");
    heard(
        "call/cca",
        """
        {"id":"CCA-G1-1","r":"rose","f":"pick","p":{"object":"Cup"},"t":1000,"from":"cca","task":"G1","v":"1.3"}
        """);
    heard(
        "result/cca/rose",
        """
        {"id":"CCA-G1-1","from":"rose","outcome":"SUCCEEDED","z":"standby","values":{},"v":"1.3"}
        """);
    said("inform", "rose", "CCA", "C-2", "((inform (:outputs)))");

    assertThat(trace("G1"))
        .containsExactly(
            "story step null null",
            "agents cfp CCA rose",
            "agents propose rose CCA",
            "agents request CCA rose",
            "bus call cca rose",
            "bus result rose cca",
            "agents inform rose CCA");
    assertThat(trace("G2")).containsExactly("agents request CCA rose");
    assertThat(traces.trace("G3")).isEmpty();
  }

  /**
   * A call that the central agent has not named its goal on is known by the order that led to it.
   */
  @Test
  void aCallIsOfTheGoalOfItsOrderAndItsEndOfTheSame() {
    said("request", "CCA", "rose", "C-2", "((perform (:goal G1) (:call \"CCA-G1-1\")))");
    heard(
        "call/cca",
        """
        {"id":"CCA-G1-1","r":"rose","f":"watch","p":{},"t":1000,"from":"cca","v":"1.3"}
        """);
    heard(
        "call/cca",
        """
        {"id":"cca-9","r":"rose","f":"$cancel","p":{"id":"CCA-G1-1"},"t":1000,"from":"cca","v":"1.3"}
        """);
    heard(
        "result/cca/rose",
        """
        {"id":"cca-9","from":"rose","outcome":"SUCCEEDED","z":"safe","values":{},"v":"1.3"}
        """);

    assertThat(trace("G1"))
        .containsExactly(
            "agents request CCA rose",
            "bus call cca rose",
            "bus call cca rose",
            "bus result rose cca");
  }

  @Test
  void whatIsSaidAgainAndAgainIsOneLine() {
    said("request", "CCA", "cam", "C-2", "((perform (:goal G1) (:call \"CCA-G1-1\")))");
    for (int second = 1; second <= 30; second++) {
      now = Duration.ofSeconds(second);
      heard(
          "member/cam/observation/watch",
          """
          {"id":"CCA-G1-1","from":"cam","f":"watch","values":{"lux":%d},"v":"1.3"}
          """
              .formatted(second));
      said("inform", "cam", "knowledge", "", "((inform (:goal G1) (:outputs (:lux 1))))");
    }

    assertThat(trace("G1"))
        .containsExactly(
            "agents request CCA cam",
            "bus observation cam null 30 times until 30.0",
            "agents inform cam knowledge 30 times until 30.0");
    assertThat(traces.trace("G1").orElseThrow().at("/trace/1/text").asText()).isEqualTo("{lux=30}");
  }

  @Test
  void theLatestOfTheLatestIsKeptAndWhatIsNotIsCounted() {
    for (int sentence = 1; sentence <= 450; sentence++) {
      story("G1", "Sentence " + sentence);
    }

    JsonNode document = traces.trace("G1").orElseThrow();
    assertThat(document.path("dropped").asInt()).isEqualTo(50);
    assertThat(document.at("/trace/0/text").asText()).isEqualTo("Sentence 51");
    assertThat(document.path("trace")).hasSize(400);

    for (int goal = 2; goal <= 101; goal++) {
      story("G" + goal, "Sentence");
    }
    assertThat(traces.trace("G1")).as("of the latest hundred goals").isEmpty();
    assertThat(traces.trace("G101")).isPresent();
  }

  @Test
  void secretsAreMaskedAndWhoOnlyAsksAndWhatIsNotUnderstoodAreLeftOut() {
    said("request", "CCA", "rose", "C-1", "((perform (:goal G1) (:password \"abc\")))");
    said("request", "desk", "CCA", "C-9", "(explain (:goal G1))");
    said("query-ref", "desk", "CCA", "C-10", "(query-ref)");
    said("inform", "CCA", "desk", "C-10", "(inform (:goal G1 \"(nextTo Cup Bob)\"))");
    heard("call/cca", "{\"id\":");
    heard("call/cca", "no call");

    assertThat(trace("G1")).hasSize(1);
    assertThat(traces.trace("G1").orElseThrow().toString()).doesNotContain("abc");
  }
}
