package org.maestro.language.lexicon;

import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.regex.Pattern;

/** Numbers in words and figures: twenty-five, two hundred and ten, 0.5. Immutable. */
final class NumberWords {
  private static final Pattern FIGURES = Pattern.compile("-?\\d{1,12}([.,]\\d{1,6})?");

  private final Map<String, Double> values;
  private final Map<String, Double> times;

  NumberWords(Map<String, Double> values, Map<String, Double> times) {
    this.values = values;
    this.times = times;
  }

  /** The number that these words are, all of them together. */
  OptionalDouble value(List<String> words) {
    if (words.size() == 1 && FIGURES.matcher(words.get(0)).matches()) {
      return OptionalDouble.of(Double.parseDouble(words.get(0).replace(',', '.')));
    }
    double total = 0;
    double part = 0;
    double smallest = Double.POSITIVE_INFINITY;
    boolean any = false;
    for (String word : words) {
      Double value = values.get(word);
      Double factor = times.get(word);
      if (value != null) {
        // Twenty five is a number, five twenty and five six are two.
        if (any && (value >= smallest || smallest < 20 || value >= 10 && smallest < 100)) {
          return OptionalDouble.empty();
        }
        part += value;
        smallest = value == 0 ? 0 : value;
        any = true;
      } else if (factor != null && any) {
        part *= factor;
        total += part;
        part = 0;
        smallest = factor;
      } else {
        return OptionalDouble.empty();
      }
    }
    return any ? OptionalDouble.of(total + part) : OptionalDouble.empty();
  }
}
