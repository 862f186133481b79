package org.maestro.launch;

import java.util.Map;
import org.maestro.planning.api.Objective;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Option;
import picocli.CommandLine.TypeConversionException;

/** The option that says who gets which steps. */
final class Allocation {

  @Option(
      names = "--allocation",
      paramLabel = "WAY",
      defaultValue = "cheapest",
      converter = Word.class,
      description =
          "Who gets which steps: cheapest, or earliest for the plan that is over first; default"
              + " ${DEFAULT-VALUE}.")
  private Objective objective;

  Objective objective() {
    return objective;
  }

  /** Reads the strategy's word. */
  static final class Word implements ITypeConverter<Objective> {
    private static final Map<String, Objective> WORDS =
        Map.of("cheapest", Objective.CHEAPEST, "earliest", Objective.EARLIEST_FINISH);

    @Override
    public Objective convert(String word) {
      Objective objective = WORDS.get(word);
      if (objective == null) {
        throw new TypeConversionException(
            "\"" + word + "\" is no way to allocate steps; say cheapest or earliest");
      }
      return objective;
    }
  }
}
