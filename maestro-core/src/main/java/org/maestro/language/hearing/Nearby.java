package org.maestro.language.hearing;

import java.util.List;
import java.util.stream.Stream;

/** Words that sound or look much like another. */
final class Nearby {
  private static final int SHORT = 4;
  private static final int LONG = 8;

  private Nearby() {}

  /**
   * Those of the words for which another may have been misheard; none of short ones, nor a short
   * one of what is longer: who says milk has not said I.
   */
  static List<String> of(String word, Stream<String> words) {
    if (word.length() < SHORT) {
      return List.of();
    }
    int most = word.length() >= LONG ? 2 : 1;
    return words
        .filter(other -> Math.abs(other.length() - word.length()) <= most)
        .filter(other -> other.length() > SHORT || word.length() <= other.length())
        .filter(other -> !other.isEmpty() && other.charAt(0) == word.charAt(0))
        .filter(other -> distance(word, other) <= most)
        .distinct()
        .sorted()
        .toList();
  }

  /** How many letters differ, are missing, are too many, or stand the other way round. */
  private static int distance(String one, String other) {
    int[][] cost = new int[one.length() + 1][other.length() + 1];
    for (int i = 0; i <= one.length(); i++) {
      for (int j = 0; j <= other.length(); j++) {
        if (i == 0 || j == 0) {
          cost[i][j] = i + j;
          continue;
        }
        boolean same = one.charAt(i - 1) == other.charAt(j - 1);
        int least =
            Math.min(
                cost[i - 1][j - 1] + (same ? 0 : 1), 1 + Math.min(cost[i - 1][j], cost[i][j - 1]));
        if (i > 1
            && j > 1
            && one.charAt(i - 1) == other.charAt(j - 2)
            && one.charAt(i - 2) == other.charAt(j - 1)) {
          least = Math.min(least, cost[i - 2][j - 2] + 1);
        }
        cost[i][j] = least;
      }
    }
    return cost[one.length()][other.length()];
  }
}
