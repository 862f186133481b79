package org.maestro.launch;

import java.util.List;
import java.util.Optional;
import org.maestro.agents.content.AskedStakes;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The options that say what a goal is worth. */
final class StakesOptions {
  @Option(
      names = "--benefit",
      paramLabel = "B",
      description =
          "What it brings to have it reached, in seconds of work: a number, or an expression such as \"(+ 40 (level lamp-a1))\".")
  private Optional<String> benefit = Optional.empty();

  @Option(
      names = "--chance",
      paramLabel = "P",
      description = "That it is reached, 0 to 1, as long as nothing like it was tried. Usual: 0.8.")
  private Optional<Double> chance = Optional.empty();

  @Option(
      names = "--allowed",
      paramLabel = "SECONDS",
      description =
          "Simulated seconds within which its urgency grows to the highest. Usual: until the deadline.")
  private Optional<Double> allowedSeconds = Optional.empty();

  @Option(
      names = "--urgency",
      paramLabel = "FROM..TO",
      converter = Range.Reader.class,
      description = "Its urgency at the beginning and at the end of that time. Usual: 1..10.")
  private Optional<Range> urgency = Optional.empty();

  AskedStakes asked() {
    return new AskedStakes(
        benefit, chance, allowedSeconds, urgency.map(Range::from), urgency.map(Range::to));
  }

  /** Two numbers. */
  record Range(double from, double to) {

    /** Reads {@code 1..10}. */
    static final class Reader implements ITypeConverter<Range> {
      @Override
      public Range convert(String text) {
        List<String> bounds = List.of(text.split("\\.\\.", -1));
        try {
          if (bounds.size() == 2) {
            return new Range(Double.parseDouble(bounds.get(0)), Double.parseDouble(bounds.get(1)));
          }
        } catch (NumberFormatException e) {
          // It is told below, as what has too few or too many bounds is.
        }
        throw new TypeConversionException(
            "'%s' is no range; write two numbers, such as 1..10".formatted(text));
      }
    }
  }
}
