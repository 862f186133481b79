package org.maestro.language.lexicon;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.regex.Pattern;

/** Numbers in words, and in figures: twenty-five, two hundred and ten, 0.5. Immutable. */
final class NumberWords {
  private static final double TEN = 10;
  private static final Pattern FIGURES = Pattern.compile("-?\\d{1,12}([.,]\\d{1,6})?");

  private final Map<String, Double> values;
  private final Map<String, Double> times;
  private final Set<List<String>> joining;
  private final Set<List<String>> turning;
  private final Set<List<String>> singular;

  /**
   * @param joining words that stand between hundreds and the rest
   * @param turning words that stand between ones and the tens after them, where numbers are written
   *     as one word; none: they are not
   * @param singular words that are one before a hundred or a thousand, and nowhere else
   */
  NumberWords(
      Map<String, Double> values,
      Map<String, Double> times,
      Set<List<String>> joining,
      Set<List<String>> turning,
      Set<List<String>> singular) {
    this.values = values;
    this.times = times;
    this.joining = joining;
    this.turning = turning;
    this.singular = singular;
  }

  /** The words of which numbers are made. */
  Set<String> words() {
    return values.keySet();
  }

  /** Whether one word is a whole number, however long. */
  boolean areOneWord() {
    return !turning.isEmpty();
  }

  /** The number that these words are, all of them together. */
  OptionalDouble value(List<String> words) {
    if (words.size() == 1 && FIGURES.matcher(words.get(0)).matches()) {
      return OptionalDouble.of(Double.parseDouble(words.get(0).replace(',', '.')));
    }
    if (words.size() == 1 && areOneWord() && !isPart(words.get(0))) {
      return parts(words.get(0)).map(this::inWords).orElse(OptionalDouble.empty());
    }
    return words.isEmpty() ? OptionalDouble.empty() : inWords(words);
  }

  /** Whether it is one before a hundred. */
  boolean isSingular(String word) {
    return singular.contains(List.of(word));
  }

  private boolean isPart(String word) {
    return values.containsKey(word) || times.containsKey(word);
  }

  /** The words of which one is made; the tens before the ones. */
  private Optional<List<String>> parts(String word) {
    if (word.isEmpty()) {
      return Optional.of(List.of());
    }
    for (int end = word.length(); end > 0; end--) {
      String first = word.substring(0, end);
      if (isPart(first)) {
        Optional<List<String>> rest = parts(word.substring(end));
        if (rest.isPresent() && !isTensBeforeOnes(first, rest.get())) {
          return Optional.of(with(first, rest.get()));
        }
        Optional<List<String>> turned = turned(first, word.substring(end));
        if (turned.isPresent()) {
          return turned;
        }
      }
    }
    return Optional.empty();
  }

  private boolean isTensBeforeOnes(String first, List<String> rest) {
    return !rest.isEmpty()
        && values.getOrDefault(first, 0.0) >= 2 * TEN
        && values.getOrDefault(rest.get(0), TEN) < TEN;
  }

  /** Ones, a word that turns them, and tens. */
  private Optional<List<String>> turned(String ones, String rest) {
    double value = values.getOrDefault(ones, TEN);
    return turning.stream()
        .map(word -> word.get(0))
        .filter(word -> value < TEN && rest.startsWith(word))
        .map(word -> rest.substring(word.length()))
        .filter(tens -> values.getOrDefault(tens, 0.0) >= 2 * TEN)
        .map(tens -> List.of(tens, ones))
        .findFirst();
  }

  private static List<String> with(String first, List<String> rest) {
    List<String> all = new ArrayList<>(List.of(first));
    all.addAll(rest);
    return all;
  }

  private OptionalDouble inWords(List<String> words) {
    boolean isOne = words.size() > 1 && isSingular(words.get(0)) && times.containsKey(words.get(1));
    double total = 0;
    double part = isOne ? 1 : 0;
    double smallest = isOne ? 1 : Double.POSITIVE_INFINITY;
    double largestFactor = 0;
    double lastFactor = Double.POSITIVE_INFINITY;
    boolean isCounted = isOne;
    for (String word : words.subList(isOne ? 1 : 0, words.size())) {
      Double value = values.get(word);
      Double factor = times.get(word);
      if (value != null) {
        // Twenty five is a number, five twenty and five six are two.
        boolean isLower = value < smallest && smallest >= 20 && (value < 10 || smallest >= 100);
        if (!isLower || value == 0 && words.size() > 1) {
          return OptionalDouble.empty();
        }
        part += value;
        smallest = value;
        isCounted = true;
      } else if (factor != null && !isCounted && areOneWord()) {
        // Where numbers are one word, a hundred may be one of them.
        total = factor;
        largestFactor = factor;
        lastFactor = factor;
        smallest = factor;
        isCounted = true;
      } else if (factor != null && isCounted && factor > largestFactor) {
        total = (total + part) * factor;
        largestFactor = factor;
        lastFactor = factor;
        part = 0;
        smallest = factor;
      } else if (factor != null && factor < lastFactor && part > 0) {
        total += part * factor;
        lastFactor = factor;
        part = 0;
        smallest = factor;
      } else if (!isJoining(word) || part > 0 || total == 0) {
        return OptionalDouble.empty();
      }
    }
    return isJoining(words.get(words.size() - 1))
        ? OptionalDouble.empty()
        : OptionalDouble.of(total + part);
  }

  private boolean isJoining(String word) {
    return joining.contains(List.of(word));
  }
}
