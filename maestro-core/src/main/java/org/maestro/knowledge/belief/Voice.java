package org.maestro.knowledge.belief;

import java.util.OptionalDouble;
import org.maestro.knowledge.api.Source;

/**
 * The speaker of a statement, and how sure it is of what it says.
 *
 * @param confidence 0 (worthless) to 1 (certain)
 * @param coveredShare the share of a place's floor, 0 to 1, of which it speaks, where it says so
 */
public record Voice(Source source, double confidence, OptionalDouble coveredShare) {

  public Voice(Source source, double confidence) {
    this(source, confidence, OptionalDouble.empty());
  }

  boolean expects() {
    return source.kind() == Source.Kind.EXPECTED;
  }
}
