package org.maestro.language.lexicon;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.regex.Pattern;

/** Numbers as they are spoken: below zero, with a half, and with what stands behind the mark. */
final class SpokenNumbers {
  private static final Pattern DIGITS = Pattern.compile("\\d{1,6}");
  private static final double HALF = 0.5;
  private static final int TEN = 10;
  private static final int HUNDRED = 100;

  private final NumberWords whole;
  private final Set<List<String>> negative;
  private final Set<List<String>> marks;
  private final Set<List<String>> halves;
  private final Set<List<String>> noughts;

  /**
   * @param whole those without any of these
   * @param negative words before a number below zero
   * @param marks words between a whole number and its decimals
   * @param halves words that add a half behind a number, or at its end where numbers are one word
   * @param noughts words for a nought among decimals, which are no numbers elsewhere
   */
  SpokenNumbers(
      NumberWords whole,
      Set<List<String>> negative,
      Set<List<String>> marks,
      Set<List<String>> halves,
      Set<List<String>> noughts) {
    this.whole = whole;
    this.negative = negative;
    this.marks = marks;
    this.halves = halves;
    this.noughts = noughts;
  }

  /** Whether the word can be one of a number. */
  boolean knows(String word) {
    return isListed(negative, word) || isListed(marks, word) || value(List.of(word)).isPresent();
  }

  /** The number that these words are, all of them together. */
  OptionalDouble value(List<String> words) {
    if (words.size() == 1 || !isListed(negative, words.get(0))) {
      return unsigned(words);
    }
    OptionalDouble value = unsigned(words.subList(1, words.size()));
    boolean isSignedTwice = value.isEmpty() || value.getAsDouble() < 0;
    return isSignedTwice ? OptionalDouble.empty() : OptionalDouble.of(0 - value.getAsDouble());
  }

  /** Whether the words are no number yet, and would be one with more. */
  boolean isBeginning(List<String> words) {
    int size = words.size();
    String last = words.get(size - 1);
    if (size == 1) {
      return isListed(negative, last) || whole.isSingular(last);
    }
    return isListed(marks, last) && value(words.subList(0, size - 1)).isPresent()
        || isBeginningOfHalf(words);
  }

  private boolean isBeginningOfHalf(List<String> words) {
    for (List<String> half : halves) {
      for (int said = 1; said < half.size(); said++) {
        int before = words.size() - said;
        if (before > 0
            && words.subList(before, words.size()).equals(half.subList(0, said))
            && value(words.subList(0, before)).isPresent()) {
          return true;
        }
      }
    }
    return false;
  }

  private OptionalDouble unsigned(List<String> words) {
    for (int mark = 1; mark < words.size() - 1; mark++) {
      if (isListed(marks, words.get(mark))) {
        return decimal(words.subList(0, mark), words.subList(mark + 1, words.size()));
      }
    }
    OptionalDouble value = whole.value(words);
    return value.isPresent() ? value : withHalf(words);
  }

  private OptionalDouble decimal(List<String> before, List<String> after) {
    OptionalDouble number = whole.value(before);
    String digits = digits(after);
    return number.isEmpty() || !isWhole(number.getAsDouble()) || digits.isEmpty()
        ? OptionalDouble.empty()
        : OptionalDouble.of(Double.parseDouble((long) number.getAsDouble() + "." + digits));
  }

  /** Said one by one, or two of them as a number; none when they are no digits. */
  private String digits(List<String> words) {
    StringBuilder digits = new StringBuilder();
    for (String word : words) {
      OptionalDouble one = whole.value(List.of(word));
      if (DIGITS.matcher(word).matches()) {
        digits.append(word);
      } else if (isListed(noughts, word)) {
        digits.append('0');
      } else if (isWholeFrom(one, 0, TEN)) {
        digits.append((int) one.getAsDouble());
      } else {
        OptionalDouble both = whole.value(words);
        return isWholeFrom(both, TEN, HUNDRED) ? String.valueOf((int) both.getAsDouble()) : "";
      }
    }
    return digits.toString();
  }

  private static boolean isWholeFrom(OptionalDouble number, int least, int below) {
    return number.isPresent()
        && isWhole(number.getAsDouble())
        && number.getAsDouble() >= least
        && number.getAsDouble() < below;
  }

  private OptionalDouble withHalf(List<String> words) {
    for (List<String> half : halves) {
      int before = words.size() - half.size();
      if (before > 0 && words.subList(before, words.size()).equals(half)) {
        return plusHalf(whole.value(words.subList(0, before)));
      }
      String ending = half.get(0);
      String last = words.get(words.size() - 1);
      if (whole.areOneWord()
          && words.size() == 1
          && last.endsWith(ending)
          && !last.equals(ending)) {
        return plusHalf(whole.value(List.of(last.substring(0, last.length() - ending.length()))));
      }
    }
    return OptionalDouble.empty();
  }

  /** Nobody says so of a figure with decimals or a sign. */
  private static OptionalDouble plusHalf(OptionalDouble number) {
    return isWholeFrom(number, 0, Integer.MAX_VALUE)
        ? OptionalDouble.of(number.getAsDouble() + HALF)
        : OptionalDouble.empty();
  }

  private static boolean isWhole(double number) {
    return number == Math.rint(number);
  }

  private static boolean isListed(Set<List<String>> list, String word) {
    return list.contains(List.of(word));
  }
}
