package org.maestro.ontology.vocabulary;

import java.util.List;
import java.util.OptionalDouble;
import org.maestro.sl.Term;

/**
 * The source of a fluent's number that is not stated by itself: the text of another property.
 *
 * @param property local name of that property
 * @param numbers which of the text's numbers count, from 1 on; the least of them is taken
 */
public record TakenFrom(String property, List<Integer> numbers) {
  public TakenFrom {
    numbers = List.copyOf(numbers);
  }

  /** The number; empty when the value is no text that has these numbers. */
  public OptionalDouble number(Term value) {
    if (!(value instanceof Term.Text text) || numbers.isEmpty()) {
      return OptionalDouble.empty();
    }
    String[] words = text.value().strip().split("\\s+");
    double least = Double.POSITIVE_INFINITY;
    for (int number : numbers) {
      if (number < 1 || number > words.length) {
        return OptionalDouble.empty();
      }
      try {
        least = Math.min(least, Double.parseDouble(words[number - 1]));
      } catch (NumberFormatException e) {
        return OptionalDouble.empty();
      }
    }
    return Double.isFinite(least) ? OptionalDouble.of(least) : OptionalDouble.empty();
  }
}
