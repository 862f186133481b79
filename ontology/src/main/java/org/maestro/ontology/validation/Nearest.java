package org.maestro.ontology.validation;

import java.util.Collection;
import java.util.Comparator;
import java.util.Optional;
import java.util.function.UnaryOperator;

/** Finds the name that somebody may have meant. */
public final class Nearest {

  private static final int FEW_EDITS = 2;

  private Nearest() {}

  /**
   * What to write in place of an unknown name: the nearest known one, or what kind of name is
   * wanted.
   */
  public static String cure(String name, Collection<String> known, String wanted) {
    return cure(name, known, UnaryOperator.identity(), wanted);
  }

  /**
   * The same where a name is not written as it is compared.
   *
   * @param written how a known name is written, such as with its prefix
   */
  public static String cure(
      String name, Collection<String> known, UnaryOperator<String> written, String wanted) {
    return to(name, known)
        .map(other -> "write " + written.apply(other) + ", if that is meant")
        .orElse(wanted);
  }

  /**
   * The nearest known name, if any is near; of those as near as each other, the one that begins
   * more alike.
   */
  public static Optional<String> to(String name, Collection<String> known) {
    return known.stream()
        .filter(other -> isNear(name, other))
        .min(
            Comparator.comparingInt((String other) -> edits(name, other))
                .thenComparing(other -> -commonLetters(name, other))
                .thenComparing(Comparator.naturalOrder()));
  }

  /** Names that differ more than by a slip begin alike. */
  private static boolean isNear(String name, String other) {
    int edits = edits(name, other);
    return edits <= Math.min(FEW_EDITS, name.length() / 2)
        && (edits < FEW_EDITS || commonLetters(name, other) > 0);
  }

  /** How many letters both begin with; case does not count. */
  private static int commonLetters(String name, String other) {
    int letters = 0;
    while (letters < Math.min(name.length(), other.length())
        && Character.toLowerCase(name.charAt(letters))
            == Character.toLowerCase(other.charAt(letters))) {
      letters++;
    }
    return letters;
  }

  /** How many letters must be changed, put in or left out; case does not count. */
  private static int edits(String a, String b) {
    int[] before = new int[b.length() + 1];
    for (int j = 0; j <= b.length(); j++) {
      before[j] = j;
    }
    for (int i = 1; i <= a.length(); i++) {
      int[] row = new int[b.length() + 1];
      row[0] = i;
      for (int j = 1; j <= b.length(); j++) {
        boolean same =
            Character.toLowerCase(a.charAt(i - 1)) == Character.toLowerCase(b.charAt(j - 1));
        row[j] = Math.min(Math.min(row[j - 1], before[j]) + 1, before[j - 1] + (same ? 0 : 1));
      }
      before = row;
    }
    return before[b.length()];
  }
}
