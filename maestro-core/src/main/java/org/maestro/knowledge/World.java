package org.maestro.knowledge;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Term;

/**
 * All that is known, by predicate and arguments. Immutable; a write copies only the predicates it
 * touches, so that a snapshot costs nothing.
 *
 * @param cells by predicate, then by the variable's arguments
 */
record World(
    long version,
    Home home,
    Declarations declarations,
    Described described,
    Measures measures,
    Map<String, Map<List<Term>, Cell>> cells) {
  World {
    cells = Collections.unmodifiableMap(new TreeMap<>(cells));
  }

  static World of(Home home, Measures measures) {
    return new World(0, home, new Declarations(home), new Described(home), measures, Map.of());
  }

  World with(Home changed, Measures itsMeasures, long newVersion) {
    return new World(
        newVersion, changed, new Declarations(changed), new Described(changed), itsMeasures, cells);
  }

  World atVersion(long same) {
    return new World(same, home, declarations, described, measures, cells);
  }

  Optional<Cell> cell(StateVariable variable) {
    return Optional.ofNullable(
        cells.getOrDefault(variable.predicate(), Map.of()).get(variable.arguments()));
  }

  /**
   * The variables of which something is known, in no order that means anything but always the same.
   */
  List<StateVariable> variables() {
    List<StateVariable> variables = new ArrayList<>();
    cells.forEach(
        (predicate, byArguments) ->
            byArguments.keySet().forEach(a -> variables.add(new StateVariable(predicate, a))));
    return variables;
  }

  /** The first instant after which something that is known does not count any more. */
  Instant nextExpiry() {
    Instant earliest = Instant.MAX;
    for (Map<List<Term>, Cell> byArguments : cells.values()) {
      for (Cell cell : byArguments.values()) {
        Instant own = cell.nextExpiry();
        earliest = own.isBefore(earliest) ? own : earliest;
      }
    }
    return earliest;
  }
}
