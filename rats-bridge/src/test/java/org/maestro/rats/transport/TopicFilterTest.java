package org.maestro.rats.transport;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TopicFilterTest {

  @ParameterizedTest
  @CsvSource({
    "a/b, a/b, true",
    "a/b, a/b/c, false",
    "a/b/c, a/b, false",
    "a/+, a/b, true",
    "a/+, a, false",
    "a/+, a/, true",
    "+/b, a/b, true",
    "a/#, a, true",
    "a/#, a/b/c, true",
    "a/#, b, false",
    "#, a/b, true",
    "a/+/#, a/b, true",
    "a/+/#, a, false",
    "a/+/c, a/b/d, false"
  })
  void matchesAsMqttDoes(String filter, String topic, boolean matches) {
    assertThat(TopicFilter.of(filter).matches(topic)).isEqualTo(matches);
  }
}
