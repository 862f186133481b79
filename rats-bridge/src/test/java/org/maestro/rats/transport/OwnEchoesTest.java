package org.maestro.rats.transport;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import org.junit.jupiter.api.Test;

/** Who published what comes back from the broker. */
class OwnEchoesTest {
  private final OwnEchoes<String> echoes = new OwnEchoes<>();

  @Test
  void eachComesBackOnce() {
    echoes.expect("rose", publication("call/rose", "a"));
    echoes.expect("lamp", publication("call/lamp", "a"));

    assertThat(publisher("call/rose", "a")).contains("rose");
    assertThat(publisher("call/rose", "a")).as("another's of the same words").isEmpty();
    assertThat(publisher("call/lamp", "b")).isEmpty();
    assertThat(publisher("call/lamp", "a")).contains("lamp");
    assertThat(publisher("call/nobody", "a")).isEmpty();
  }

  @Test
  void ofTheSameTopicEachHasItsOwn() {
    echoes.expect("rose", publication("call", "a"));
    echoes.expect("lamp", publication("call", "b"));

    assertThat(publisher("call", "b")).contains("lamp");
    assertThat(publisher("call", "a")).contains("rose");
  }

  @Test
  void noneComesBackOverALostConnection() {
    echoes.expect("rose", publication("call", "a"));
    echoes.connectionLost();

    assertThat(publisher("call", "a")).isEmpty();
  }

  @Test
  void thoseThatNeverComeBackAreForgotten() {
    echoes.expect("rose", publication("call", "lost"));
    for (int number = 0; number < 256; number++) {
      echoes.expect("rose", publication("call", "n" + number));
    }

    assertThat(publisher("call", "lost")).isEmpty();
    assertThat(publisher("call", "n0")).contains("rose");
    assertThat(publisher("call", "n255")).contains("rose");
  }

  private Optional<String> publisher(String topic, String text) {
    return echoes.publisher(new Message(topic, text.getBytes(UTF_8), false, Optional.empty()));
  }

  private static Publication publication(String topic, String text) {
    return Publication.stream(topic, text.getBytes(UTF_8));
  }
}
