package org.maestro.platform.journal;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * The part of a journal that is missing from a damaged line on, as far as the lines after it tell.
 */
final class JournalLoss {
  private final List<String> lines;
  private final int from;

  /**
   * @param from the number of the first line that is not as it should be
   */
  JournalLoss(List<String> lines, int from) {
    this.lines = lines;
    this.from = from;
  }

  /** To go on in the middle of a sentence; empty when no other line is missing. */
  String words() {
    Optional<Integer> next = next();
    String missing =
        next.filter(number -> number > from)
            .map(
                number ->
                    number == from + 1
                        ? ", so line %d is missing".formatted(from)
                        : ", so the lines %d to %d are missing".formatted(from, number - 1))
            .orElse("");
    Set<String> goals = goalsWithoutBeginning();
    return goals.isEmpty()
        ? missing
        : missing + ", and what these goals were is not said any more: " + String.join(", ", goals);
  }

  /** The number that the first whole line from there on says it has. */
  private Optional<Integer> next() {
    return lines.subList(from - 1, lines.size()).stream()
        .flatMap(line -> read(line).stream())
        .map(JournalLine::number)
        .findFirst();
  }

  private Set<String> goalsWithoutBeginning() {
    Set<String> goals = new TreeSet<>();
    Set<String> begun = new TreeSet<>();
    for (String line : lines) {
      Optional<JsonNode> fields = read(line);
      String goal = fields.map(of -> of.path("goal").asText()).orElse("");
      if (fields.filter(of -> of.path("event").asText().equals("submitted")).isPresent()) {
        begun.add(goal);
      } else if (!goal.isEmpty()) {
        goals.add(goal);
      }
    }
    goals.removeAll(begun);
    return goals;
  }

  private static Optional<JsonNode> read(String line) {
    try {
      return Optional.of(JournalLine.read(line));
    } catch (JournalDamage damaged) {
      return Optional.empty();
    }
  }
}
