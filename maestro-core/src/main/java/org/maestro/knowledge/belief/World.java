package org.maestro.knowledge.belief;

import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.ontology.home.Home;

/** All that is known. Immutable; a snapshot costs nothing. */
public record World(
    long version,
    Home home,
    Declarations declarations,
    Described described,
    Measures measures,
    Cells cells) {

  public static World of(Home home, Measures measures) {
    return new World(0, home, new Declarations(home), new Described(home), measures, Cells.none());
  }

  public World with(Home changed, Measures itsMeasures, long newVersion) {
    return new World(
        newVersion, changed, new Declarations(changed), new Described(changed), itsMeasures, cells);
  }

  public World with(Cells changed, long newVersion) {
    return new World(newVersion, home, declarations, described, measures, changed);
  }

  public Optional<Cell> cell(StateVariable variable) {
    return cells.get(variable);
  }

  /** The variables of which something is or was known, in the order of first mention. */
  public List<StateVariable> variables() {
    List<StateVariable> variables = new ArrayList<>();
    cells.forEach((variable, cell) -> variables.add(variable));
    return variables;
  }

  /**
   * The variables of which something else may count now than in the other world then; empty when
   * the home is described otherwise.
   */
  @SuppressWarnings("ReferenceEquality") // Each description makes other objects.
  Optional<Set<Object>> changedSince(World other, Instant then, Instant now) {
    if (described != other.described || measures != other.measures || home != other.home) {
      return Optional.empty();
    }
    Instant earlier = then.isBefore(now) ? then : now;
    Instant later = then.isBefore(now) ? now : then;
    Set<Object> changed = new LinkedHashSet<>();
    boolean comparable =
        cells.forEachDifference(
            other.cells,
            (variable, cell) -> {
              changed.add(variable);
              if (!declarations.isObservable(variable.predicate())) {
                changed.add(new Relation(variable.predicate()));
              }
            });
    cells.forEach(
        (variable, cell) -> {
          if (cell.expiresWithin(earlier, later)) {
            changed.add(variable);
          }
        });
    return comparable ? Optional.of(changed) : Optional.empty();
  }

  /** The first instant after which something that is known does not count any more. */
  public Instant nextExpiry() {
    Instant[] earliest = {Instant.MAX};
    cells.forEach(
        (variable, cell) -> {
          Instant own = cell.nextExpiry();
          earliest[0] = own.isBefore(earliest[0]) ? own : earliest[0];
        });
    return earliest[0];
  }
}
