package org.maestro.experiment.setting;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.parameters.PhysicalSettings;

/**
 * Something that can be set.
 *
 * @param name such as {@code world.camera.noise}
 * @param usual its value unless it is set
 * @param meaning what it is, with its unit and where the usual value comes from
 */
public record Setting(String name, String usual, Range range, String meaning) {

  /** The range of values that are allowed. */
  sealed interface Range {

    /** From the least to the greatest, both included. */
    record Number(double least, double greatest) implements Range {}

    /** True or false. */
    record Truth() implements Range {}

    /** One of some words. */
    record Choice(List<String> words) implements Range {
      public Choice {
        words = List.copyOf(words);
      }
    }

    /** The range that the simulated world has for the setting. */
    record Physical() implements Range {}
  }

  public static Setting number(
      String name, double usual, double least, double greatest, String meaning) {
    return new Setting(name, plain(usual), new Range.Number(least, greatest), meaning);
  }

  public static Setting truth(String name, boolean usual, String meaning) {
    return new Setting(name, String.valueOf(usual), new Range.Truth(), meaning);
  }

  public static Setting choice(String name, String usual, List<String> words, String meaning) {
    return new Setting(name, usual, new Range.Choice(words), meaning);
  }

  /**
   * @throws SettingException when it may not have this value
   * @throws org.maestro.sim.scene.SimulationException when the world cannot be so
   */
  void check(String value) {
    if (range instanceof Range.Physical) {
      PhysicalSettings.apply(PhysicalParameters.standard(), Map.of(name, value));
    } else if (range instanceof Range.Number limits) {
      checkNumber(value, limits);
    } else if (range instanceof Range.Choice choice) {
      if (!choice.words().contains(value)) {
        throw new SettingException(
            "%s is one of %s, not \"%s\"."
                .formatted(name, String.join(", ", choice.words()), value));
      }
    } else if (!value.equals("true") && !value.equals("false")) {
      throw new SettingException("%s is true or false, not \"%s\".".formatted(name, value));
    }
  }

  private void checkNumber(String value, Range.Number limits) {
    double number;
    try {
      number = Double.parseDouble(value);
    } catch (NumberFormatException e) {
      throw new SettingException("%s is a number, not \"%s\".".formatted(name, value));
    }
    if (!(number >= limits.least() && number <= limits.greatest())) {
      throw new SettingException(
          "%s lies between %s and %s, not at %s."
              .formatted(name, plain(limits.least()), plain(limits.greatest()), value));
    }
  }

  private static String plain(double number) {
    return number == Math.rint(number) && Math.abs(number) < 1e9
        ? String.valueOf((long) number)
        : String.format(Locale.ROOT, "%s", number);
  }
}
