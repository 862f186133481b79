package org.maestro.agents.pulse;

import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The answer to a sign of life.
 *
 * @param period until the next one
 * @param lease for so long the containers of the process may act
 * @param givenUp lives of containers that were given up, and have to join again
 */
record Confirmation(Duration period, Duration lease, Set<String> givenUp) {

  static Confirmation of(HeartbeatSettings settings, Collection<String> givenUp) {
    return new Confirmation(settings.period(), settings.lease(), Set.copyOf(givenUp));
  }

  String write() {
    return Stream.concat(
            Stream.of(String.valueOf(period.toMillis()), String.valueOf(lease.toMillis())),
            givenUp.stream().sorted())
        .collect(Collectors.joining(" "));
  }

  /**
   * @throws IllegalArgumentException when it is none
   */
  static Confirmation read(String text) {
    List<String> words = List.of(text.split(" "));
    if (words.size() < 2) {
      throw new IllegalArgumentException("\"" + text + "\" confirms no sign of life.");
    }
    return new Confirmation(
        millis(words.get(0)), millis(words.get(1)), Set.copyOf(words.subList(2, words.size())));
  }

  private static Duration millis(String word) {
    return Duration.ofMillis(Long.parseLong(word));
  }
}
