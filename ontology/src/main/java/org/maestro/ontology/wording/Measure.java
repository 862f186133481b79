package org.maestro.ontology.wording;

import java.util.List;
import java.util.OptionalDouble;

/**
 * How people speak of a fluent's number.
 *
 * @param step what "turn it up" adds
 * @param whole what a hundred percent is
 * @param grain to whose multiples it is told: it is known no better, or nobody wants it finer
 * @param more words such as "brighter", by which more of it is wished
 * @param less words such as "darker"
 * @param asked words such as "bright", by which "how ... is it" asks for it
 * @param timeOfDay whether it is a time of day, in minutes after midnight
 */
public record Measure(
    String fluent,
    OptionalDouble step,
    OptionalDouble whole,
    OptionalDouble grain,
    List<Said> more,
    List<Said> less,
    List<Said> asked,
    boolean timeOfDay) {
  public Measure {
    more = List.copyOf(more);
    less = List.copyOf(less);
    asked = List.copyOf(asked);
  }
}
