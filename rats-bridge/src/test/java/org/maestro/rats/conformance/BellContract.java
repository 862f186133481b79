package org.maestro.rats.conformance;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.rats.broker.TestBroker;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.transport.PahoTransport;

/** The bell in C keeps the rules of the bus, on any broker, and nothing that is sent ends it. */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
abstract class BellContract {
  private static final String SITE = "towers";
  static final Topics TOPICS = new Topics(SITE);
  static final Patience PATIENCE =
      new Patience(Duration.ofSeconds(20), Duration.ofSeconds(10), Duration.ofMillis(500));
  private static final int STROKES = 3;

  private final TestBroker broker = broker();
  private Path program = Path.of("not", "compiled", "yet");

  abstract TestBroker broker();

  @BeforeAll
  void compile(@TempDir Path directory) throws IOException, InterruptedException {
    program = BellInC.compiled(directory);
  }

  @BeforeEach
  void startBroker() {
    broker.start();
  }

  @AfterEach
  void stopBroker() {
    broker.stop();
  }

  @Test
  void keepsTheRulesOfTheBus() throws IOException {
    try (BellInC bell = start()) {
      List<Finding> findings =
          new DeviceExamination(
                  new PahoTransport(broker.uri(), "examiner"),
                  SITE,
                  BellInC.ID,
                  Optional.of(new FeatureCall("ring", Map.of())),
                  true,
                  PATIENCE)
              .run();

      assertThat(bell.isAlive()).as("%s", bell.said()).isTrue();
      assertThat(findings)
          .filteredOn(finding -> finding.verdict() != Finding.Verdict.KEPT)
          .isEmpty();
    }
  }

  @Test
  void nothingThatIsSentEndsIt() throws IOException {
    try (BellInC bell = start();
        Examiner examiner = examiner()) {
      Dialogue dialogue = new Dialogue(examiner, TOPICS, BellInC.ID, PATIENCE);
      assertThat(examiner.connects()).isTrue();
      assertThat(examiner.retained(TOPICS.status(BellInC.ID))).isPresent();
      for (long seed = 1; seed <= 2_000; seed++) {
        examiner.send(TOPICS.call(examiner.name()), broken(examiner, dialogue, new Random(seed)));
        if (seed % 100 == 0) {
          assertThat(dialogue.result(dialogue.ping()))
              .as("after the message of the seed %d: %s", seed, bell.said())
              .isPresent();
        }
      }
      assertThat(bell.isAlive()).isTrue();
    }
  }

  /** A call of which some bytes are others, gone, or there twice. */
  private static byte[] broken(Examiner examiner, Dialogue dialogue, Random chance) {
    List<String> features = List.of("$ping", "$cost", "$cancel", "$safe", "ESCAPED");
    Map<String, Object> call =
        dialogue.call(
            features.get(chance.nextInt(features.size())),
            Map.of("id", "x", "feature", "ring", "sets", List.of(Map.of("a", List.of(1.5, "b")))));
    StringBuilder text =
        new StringBuilder(
            new String(examiner.bytes(call), UTF_8)
                .replace("ESCAPED", "\\u00e4\\ud83d\\ude00 \u00e4 \ud83d\ude00"));
    for (int times = 1 + chance.nextInt(4); times > 0 && text.length() > 1; times--) {
      int at = chance.nextInt(text.length());
      switch (chance.nextInt(4)) {
        case 0 -> text.deleteCharAt(at);
        case 1 -> text.setCharAt(at, "{}[]\",:\\ue0\u0000 1".charAt(chance.nextInt(14)));
        case 2 -> text.insert(at, text.substring(at));
        default -> text.setLength(Math.max(1, at));
      }
    }
    return text.toString().getBytes(UTF_8);
  }

  @Test
  void aRepeatedCallRingsOnceAndOneThatIsEndedStops() throws IOException {
    try (BellInC bell = start();
        Examiner examiner = examiner()) {
      Dialogue dialogue = new Dialogue(examiner, TOPICS, BellInC.ID, PATIENCE);
      assertThat(examiner.connects()).isTrue();
      assertThat(examiner.retained(TOPICS.status(BellInC.ID))).isPresent();
      Map<String, Object> ring = dialogue.call("ring", Map.of());
      examiner.send(ring);
      Optional<JsonNode> first = dialogue.result(ring);
      assertThat(Dialogue.outcome(first)).isEqualTo("SUCCEEDED");
      assertThat(dialogue.result(ring)).isEqualTo(first);
      assertThat(bell.said()).isEqualTo(Collections.nCopies(STROKES, "ding"));

      Map<String, Object> ended = dialogue.call("ring", Map.of());
      int since = examiner.now();
      examiner.send(ended);
      await().until(() -> bell.said().size() > STROKES);
      Optional<JsonNode> cancel =
          dialogue.result(dialogue.call("$cancel", Map.of("id", ended.get("id"))));
      assertThat(cancel.orElseThrow().path("values").path("found").booleanValue()).isTrue();
      assertThat(Dialogue.outcome(dialogue.result(since, ended, PATIENCE.answersWithin())))
          .isEqualTo("CANCELED");
      assertThat(bell.said()).hasSizeLessThan(2 * STROKES);
    }
  }

  @Test
  void isThereAgainAfterItsBrokerWasGone() throws IOException {
    try (BellInC bell = start()) {
      assertThat(isHeard()).isTrue();
      broker.stop();
      broker.start();
      assertThat(isHeard()).isTrue();
      assertThat(bell.isAlive()).isTrue();
    }
  }

  final BellInC start() throws IOException {
    return BellInC.start(program, broker.uri(), SITE);
  }

  final boolean isHeard() {
    try (Examiner examiner = examiner()) {
      return examiner.connects()
          && examiner
              .retained(TOPICS.status(BellInC.ID))
              .filter(heard -> heard.content().path("status").asText().equals("ready"))
              .isPresent();
    }
  }

  final Examiner examiner() {
    return new Examiner(
        new PahoTransport(broker.uri(), "examiner"), TOPICS, BellInC.ID, true, PATIENCE);
  }
}
