package org.maestro.agents.pulse;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A sign of life of a process, for all its containers. In writing: for each container a line of its
 * life, its addresses with commas between them, and its name; an empty line; then a line of
 * milliseconds, a blank and a name for each agent that is silent.
 *
 * @param containers that live in the process
 * @param silences of their agents that do not work, and for how long
 */
record Beat(List<Living> containers, SortedMap<String, Duration> silences) {
  private static final String NOWHERE = "-";

  /**
   * A container that lives.
   *
   * @param life tells it apart from other containers that have had or will have the name
   * @param addresses at which it listens, {@code host:port}
   */
  record Living(String name, String life, List<String> addresses) {
    private String write() {
      return "%s %s %s"
          .formatted(life, addresses.isEmpty() ? NOWHERE : String.join(",", addresses), name);
    }

    private static Living read(String line) {
      String[] words = line.split(" ", 3);
      if (words.length < 3) {
        throw new IllegalArgumentException("\"" + line + "\" tells of no container.");
      }
      List<String> addresses = words[1].equals(NOWHERE) ? List.of() : List.of(words[1].split(","));
      return new Living(words[2], words[0], addresses);
    }
  }

  String write() {
    return Stream.of(
            containers.stream().map(Living::write),
            Stream.of(""),
            silences.entrySet().stream().map(e -> e.getValue().toMillis() + " " + e.getKey()))
        .flatMap(lines -> lines)
        .collect(Collectors.joining("\n"));
  }

  /**
   * @throws IllegalArgumentException when it is none
   */
  static Beat read(String text) {
    List<Living> containers = new ArrayList<>();
    SortedMap<String, Duration> silences = new TreeMap<>();
    boolean ofAgents = false;
    for (String line : text.lines().toList()) {
      if (ofAgents) {
        Map.Entry<String, Duration> silence = silence(line);
        silences.put(silence.getKey(), silence.getValue());
      } else if (line.isEmpty()) {
        ofAgents = true;
      } else {
        containers.add(Living.read(line));
      }
    }
    return new Beat(List.copyOf(containers), silences);
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
