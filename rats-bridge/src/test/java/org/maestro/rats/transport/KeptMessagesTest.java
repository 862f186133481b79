package org.maestro.rats.transport;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** What a broker keeps, and what of it is news after a connection was lost. */
class KeptMessagesTest {
  private final KeptMessages kept = new KeptMessages();

  @Test
  void theLastOfEachTopicIsKept() {
    hear("m/rose/status", "init");
    hear("m/rose/status", "ready");
    hear("m/lamp/status", "ready");
    kept.isSentAgain(new Message("m/rose/state", bytes("on"), false, Optional.empty()));

    assertThat(texts("m/+/status")).containsExactly("ready", "ready");
    assertThat(texts("m/rose/status")).containsExactly("ready");
    assertThat(texts("m/rose/#")).containsExactly("ready");
    assertThat(texts("m/rose/state")).isEmpty();
  }

  @Test
  void whatIsClearedIsKeptNoMore() {
    hear("m/rose/status", "ready");

    assertThat(hear("m/rose/status", "")).isFalse();
    assertThat(texts("#")).isEmpty();
  }

  @Test
  void whatIsTheSameAfterTheConnectionWasLostIsNoNews() {
    hear("m/rose/status", "ready");
    hear("m/lamp/status", "ready");
    hear("m/gone/status", "ready");
    kept.connectionLost();

    assertThat(texts("#")).as("what the broker keeps now is not known yet").isEmpty();
    assertThat(hear("m/rose/status", "ready")).isTrue();
    assertThat(hear("m/rose/status", "ready")).as("said once more").isFalse();
    assertThat(hear("m/lamp/status", "lost")).isFalse();
    assertThat(texts("#")).containsExactly("ready", "lost");
  }

  @Test
  void itIsRememberedThroughSeveralLosses() {
    hear("m/rose/status", "ready");
    kept.connectionLost();
    kept.connectionLost();

    assertThat(hear("m/rose/status", "ready")).isTrue();
  }

  private boolean hear(String topic, String text) {
    return kept.isSentAgain(new Message(topic, bytes(text), true, Optional.empty()));
  }

  private List<String> texts(String filter) {
    return kept.matching(TopicFilter.of(filter)).stream()
        .map(message -> new String(message.payload(), UTF_8))
        .toList();
  }

  private static byte[] bytes(String text) {
    return text.getBytes(UTF_8);
  }
}
