package org.maestro.bench.words;

import java.util.Optional;

/**
 * An utterance of a list, in columns between tabulators.
 *
 * @param before what was said before
 * @param means the message that it means or, after a dash, what is asked or said back
 */
public record SaidLine(
    String words,
    Optional<String> speaker,
    Optional<String> room,
    Optional<String> before,
    Optional<String> means) {

  /** The utterance of a line. */
  public static SaidLine of(String line) {
    String[] columns = line.split("\t", -1);
    return new SaidLine(
        columns[0], column(columns, 1), column(columns, 2), column(columns, 3), column(columns, 4));
  }

  private static Optional<String> column(String[] columns, int index) {
    return index < columns.length && !columns[index].isBlank()
        ? Optional.of(columns[index].strip())
        : Optional.empty();
  }
}
