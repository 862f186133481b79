package org.maestro.ontology.home;

import java.math.BigDecimal;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * What can be set at a device ({@code maestro:setting}); what its value means stands in the
 * device's reports, under the same name.
 *
 * @param name the device's own word for it, and the parameter of features that set it
 * @param grain how far apart its numbers are, counted from the lowest
 * @param atFirst its value before it is set; empty: none
 * @param delaySeconds until it is as it was set, from 0
 * @param whileOn whether it counts only while the device is switched on
 */
public record Setting(
    String name,
    OptionalDouble lowest,
    OptionalDouble highest,
    OptionalDouble grain,
    Optional<Term> atFirst,
    double delaySeconds,
    boolean whileOn) {

  /** More are told apart by nobody, and every plan would have to look at them. */
  static final int MOST_VALUES = 1000;

  /** Below a billionth of a grain two numbers are one. */
  private static final double ROUNDING = 1e-9;

  /** How many numbers it has; empty where it is no number, or its numbers are not told apart. */
  public OptionalDouble count() {
    return lowest.isPresent() && highest.isPresent() && grain.isPresent()
        ? OptionalDouble.of(Math.floor(steps(highest.getAsDouble()) + ROUNDING) + 1)
        : OptionalDouble.empty();
  }

  /** The numbers to which it can be set, from the lowest on; none where they are not told apart. */
  public List<Term> values() {
    int count = (int) count().orElse(0);
    return IntStream.range(0, count)
        .<Term>mapToObj(
            i ->
                new Term.Number(
                    BigDecimal.valueOf(grain.getAsDouble())
                        .multiply(BigDecimal.valueOf(i))
                        .add(BigDecimal.valueOf(lowest.getAsDouble()))
                        .doubleValue()))
        .toList();
  }

  /** Why it cannot be set to this; one clause, without its subject. Empty when it can. */
  public Optional<String> refusal(Term value) {
    if (lowest.isEmpty() && highest.isEmpty() && grain.isEmpty()) {
      return Optional.empty();
    }
    if (!(value instanceof Term.Number number)) {
      return Optional.of("is a number, not " + SlPrinter.print(value));
    }
    if (number.value() < lowest.orElse(Double.NEGATIVE_INFINITY)
        || number.value() > highest.orElse(Double.POSITIVE_INFINITY)) {
      return Optional.of("lies %s, and is not %s".formatted(range(), SlPrinter.print(value)));
    }
    double steps = steps(number.value());
    return grain.isPresent() && Math.abs(steps - Math.rint(steps)) > ROUNDING
        ? Optional.of(
            "goes in steps of %s, and %s is none"
                .formatted(SlPrinter.print(grain.getAsDouble()), SlPrinter.print(value)))
        : Optional.empty();
  }

  private double steps(double value) {
    return (value - lowest.orElse(0)) / grain.orElse(1);
  }

  private String range() {
    if (lowest.isPresent() && highest.isPresent()) {
      return "between %s and %s"
          .formatted(SlPrinter.print(lowest.getAsDouble()), SlPrinter.print(highest.getAsDouble()));
    }
    return lowest.isPresent()
        ? "at or above " + SlPrinter.print(lowest.getAsDouble())
        : "at or below " + SlPrinter.print(highest.orElseThrow());
  }
}
