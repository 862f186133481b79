package org.maestro.agents.pulse;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What a container says with a sign of life. In writing: a line of addresses with blanks between
 * them, then a line of milliseconds, a blank and a name for each agent that is silent.
 *
 * @param addresses at which its process listens, {@code host:port}
 * @param silences of agents that do not work, and for how long
 */
record Report(List<String> addresses, SortedMap<String, Duration> silences) {

  String write() {
    return Stream.concat(
            Stream.of(String.join(" ", addresses)),
            silences.entrySet().stream().map(e -> e.getValue().toMillis() + " " + e.getKey()))
        .collect(Collectors.joining("\n"));
  }

  /**
   * @throws IllegalArgumentException when it is none
   */
  static Report read(String text) {
    List<String> lines = text.lines().toList();
    if (lines.isEmpty()) {
      return new Report(List.of(), new TreeMap<>());
    }
    SortedMap<String, Duration> silences =
        lines.stream()
            .skip(1)
            .map(Report::silence)
            .collect(
                Collectors.toMap(
                    Map.Entry::getKey, Map.Entry::getValue, (a, b) -> b, TreeMap::new));
    return new Report(
        Stream.of(lines.get(0).split(" ")).filter(word -> !word.isBlank()).toList(), silences);
  }

  private static Map.Entry<String, Duration> silence(String line) {
    int blank = line.indexOf(' ');
    try {
      return Map.entry(
          line.substring(blank + 1),
          Duration.ofMillis(Long.parseLong(line.substring(0, Math.max(0, blank)))));
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("\"" + line + "\" tells of no silent agent.", e);
    }
  }
}
