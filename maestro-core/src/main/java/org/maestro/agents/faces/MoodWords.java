package org.maestro.agents.faces;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;

/** The expressions that stand for moods, by the words of a data file. */
final class MoodWords {
  /** The expression of whom no mood moves. */
  static final String NEUTRAL = "neutral";

  private static final String FILE = "moods.txt";
  private static final String COMMENT = "#";
  private static final Map<String, String> EXPRESSION_BY_WORD = read();

  private MoodWords() {}

  /** Of a word that the file does not have it is neutral. */
  static String expression(String mood) {
    return EXPRESSION_BY_WORD.getOrDefault(mood.toLowerCase(Locale.ROOT), NEUTRAL);
  }

  private static Map<String, String> read() {
    Map<String, String> expressions = new HashMap<>();
    for (String line : text().split("\n")) {
      int colon = line.indexOf(':');
      if (!line.startsWith(COMMENT) && colon > 0) {
        for (String word : line.substring(colon + 1).strip().split("\\s+")) {
          expressions.put(word, line.substring(0, colon));
        }
      }
    }
    return Map.copyOf(expressions);
  }

  private static String text() {
    try (InputStream file = MoodWords.class.getResourceAsStream(FILE)) {
      return new String(Objects.requireNonNull(file, FILE).readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
