package org.maestro.language.lexicon;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.regex.Pattern;

/** Numbers in words and figures: twenty-five, two hundred and ten, 0.5. Immutable. */
final class NumberWords {
  private static final Pattern FIGURES = Pattern.compile("-?\\d{1,12}([.,]\\d{1,6})?");

  private final Map<String, Double> values;
  private final Map<String, Double> times;
  private final Set<List<String>> joining;

  /**
   * @param joining words that stand between hundreds and the rest
   */
  NumberWords(Map<String, Double> values, Map<String, Double> times, Set<List<String>> joining) {
    this.values = values;
    this.times = times;
    this.joining = joining;
  }

  /** The words of which numbers are made. */
  Set<String> words() {
    return values.keySet();
  }

  /** The number that these words are, all of them together. */
  OptionalDouble value(List<String> words) {
    if (words.size() == 1 && FIGURES.matcher(words.get(0)).matches()) {
      return OptionalDouble.of(Double.parseDouble(words.get(0).replace(',', '.')));
    }
    return words.isEmpty() ? OptionalDouble.empty() : inWords(words);
  }

  private OptionalDouble inWords(List<String> words) {
    double total = 0;
    double part = 0;
    double smallest = Double.POSITIVE_INFINITY;
    double largestFactor = 0;
    double lastFactor = Double.POSITIVE_INFINITY;
    boolean isCounted = false;
    for (String word : words) {
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
