package org.maestro.persons.visits;

import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.Optional;

/**
 * What a person did who had come to a place: she went on to the next one soon, or stayed.
 *
 * @param at when she went on, or was known to stay
 * @param from where she had come from
 * @param through the place to which she had come
 * @param next where she went; the place itself if she stayed
 */
public record Passage(Instant at, String person, String from, String through, String next) {
  private static final int WORDS = 5;

  /** A line of a log. */
  String line() {
    return String.join(" ", at.toString(), person, from, through, next);
  }

  /** What a line of a log says; empty when it cannot be read. */
  static Optional<Passage> read(String line) {
    String[] words = line.split(" ");
    if (words.length != WORDS) {
      return Optional.empty();
    }
    try {
      return Optional.of(
          new Passage(Instant.parse(words[0]), words[1], words[2], words[3], words[4]));
    } catch (DateTimeParseException e) {
      return Optional.empty();
    }
  }
}
