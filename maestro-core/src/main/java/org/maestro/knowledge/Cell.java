package org.maestro.knowledge;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.maestro.sl.Term;

/**
 * What is known of one state variable. A cell without value and exclusions says that what was
 * known, or described in the home, is lost.
 *
 * @param excluded values that a functional predicate is known not to have
 */
record Cell(Optional<Held> value, Map<Term, Held> excluded) {

  static final Cell LOST = new Cell(Optional.empty(), Map.of());

  Cell {
    excluded = Collections.unmodifiableMap(new LinkedHashMap<>(excluded));
  }

  static Cell of(Held value) {
    return new Cell(Optional.of(value), Map.of());
  }

  /** An exclusion of the present value removes the value, and leaves what else was excluded. */
  Cell excluding(Held exclusion) {
    Map<Term, Held> all = new LinkedHashMap<>(excluded);
    all.remove(exclusion.value());
    all.put(exclusion.value(), exclusion);
    return new Cell(value.filter(held -> !held.value().equals(exclusion.value())), all);
  }

  Cell withoutExclusion(Term excludedValue) {
    Map<Term, Held> rest = new LinkedHashMap<>(excluded);
    rest.remove(excludedValue);
    return new Cell(value, rest);
  }

  boolean isLost() {
    return value.isEmpty() && excluded.isEmpty();
  }
}
