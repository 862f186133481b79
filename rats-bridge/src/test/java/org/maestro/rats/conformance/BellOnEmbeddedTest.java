package org.maestro.rats.conformance;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.rats.broker.RunsProgram;
import org.maestro.rats.broker.TestBroker;

@RunsProgram("cc")
class BellOnEmbeddedTest extends BellContract {

  @Override
  TestBroker broker() {
    return TestBroker.embedded();
  }

  /** This broker says why it closes a connection; mosquitto 2.0.11 does not. */
  @Test
  void ofTwoTheFirstLeavesAndSaysWhy() throws IOException {
    try (BellInC first = start()) {
      assertThat(isHeard()).isTrue();
      try (BellInC second = start()) {
        await().until(() -> !first.isAlive());
        assertThat(isHeard()).isTrue();
        assertThat(second.isAlive()).isTrue();
      }
      assertThat(first.said()).anyMatch(line -> line.startsWith("There is another bell-1"));
    }
  }

  @Test
  void itsMessagesAreAsLongAsTheGuideSays() throws IOException {
    String guide = Files.readString(Path.of("..", "docs", "guide-bus.md"));
    try (BellInC bell = start();
        Examiner examiner = examiner()) {
      Dialogue dialogue = new Dialogue(examiner, TOPICS, BellInC.ID, PATIENCE);
      assertThat(examiner.connects()).isTrue();
      Map<String, JsonNode> messages =
          Map.of(
              "description", retained(examiner, TOPICS.description(BellInC.ID)),
              "status", retained(examiner, TOPICS.status(BellInC.ID)),
              "state, at rest", retained(examiner, TOPICS.state(BellInC.ID)),
              "result of `$ping`",
                  dialogue.result(examiner.call("four", "$ping", Map.of())).orElseThrow(),
              "refusal of a feature that it has not",
                  dialogue.result(examiner.call("FOUR", "fly", Map.of())).orElseThrow());
      messages.forEach(
          (name, message) ->
              assertThat(guide).contains("| %s | %d |".formatted(name, bytes(message))));
      assertThat(bell.isAlive()).isTrue();
    }
  }

  private static JsonNode retained(Examiner examiner, String topic) {
    return examiner.retained(topic).orElseThrow().content();
  }

  /** The bell writes no blanks. */
  private static int bytes(JsonNode message) {
    return message.toString().getBytes(UTF_8).length;
  }
}
