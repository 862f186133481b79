package org.maestro.launch;

import java.util.Map;
import org.maestro.planning.api.Objective;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.TypeConversionException;

/** Reads the allocation strategy's word. */
final class Allocation implements ITypeConverter<Objective> {
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
