package org.maestro.knowledge;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.LongSupplier;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * A write under way. What a source says replaces what was known before: it was received later. Of
 * one instant, an observation stands against another source's expectation; the expectation is kept
 * as a loser. Expected numbers build on those observed, and do not contradict them.
 */
final class Draft {

  private final World base;
  private final Instant now;
  private final LongSupplier serials;
  private final Map<String, Map<List<Term>, Cell>> cells;
  private final Set<String> copied = new LinkedHashSet<>();
  private final Set<StateVariable> touched = new LinkedHashSet<>();
  private final List<Loser> losers = new ArrayList<>();

  /** A statement that was not believed. */
  record Loser(StateVariable variable, Held held, boolean has) {}

  Draft(World base, Instant now, LongSupplier serials) {
    this.base = base;
    this.now = now;
    this.serials = serials;
    this.cells = new TreeMap<>(base.cells());
  }

  World base() {
    return base;
  }

  /** The world with what was written until now. */
  World world() {
    copied.clear();
    return new World(
        base.version() + 1,
        base.home(),
        base.declarations(),
        base.described(),
        base.measures(),
        cells);
  }

  Set<StateVariable> touched() {
    return Collections.unmodifiableSet(touched);
  }

  List<Loser> losers() {
    return List.copyOf(losers);
  }

  Optional<Cell> cell(StateVariable variable) {
    return Optional.ofNullable(
        cells.getOrDefault(variable.predicate(), Map.of()).get(variable.arguments()));
  }

  void write(Fact fact, Source source, boolean fromPosition) {
    if (fact instanceof Fact.Holds holds) {
      hold(holds.atom(), source, fromPosition);
    } else if (fact instanceof Fact.Excluded excluded) {
      exclude(excluded.atom(), source, fromPosition);
    } else if (fact instanceof Fact.Equation equation) {
      equate(equation, source);
    } else if (fact instanceof Fact.Unknown unknown) {
      forget(variable(unknown.atom()));
    }
  }

  /** What was known of the variable is not known any more; exclusions go too. */
  void forget(StateVariable variable) {
    Optional<Cell> cell = cell(variable);
    if (cell.filter(c -> !c.isLost()).isPresent()
        || cell.isEmpty() && base.described().describes(variable)) {
      put(variable, Cell.LOST);
    }
  }

  /** One value is not known to be excluded any more. */
  void readmit(StateVariable variable, Term value) {
    cell(variable)
        .filter(cell -> cell.excluded().containsKey(value))
        .ifPresent(cell -> put(variable, cell.withoutExclusion(value)));
  }

  StateVariable variable(Formula.Atom atom) {
    Declarations declarations = base.declarations();
    return declarations.isFluent(atom.predicate())
        ? new StateVariable(atom.predicate(), atom.arguments())
        : declarations.variable(declarations.canonical(atom));
  }

  private void hold(Formula.Atom atom, Source source, boolean fromPosition) {
    Formula.Atom canonical = base.declarations().canonical(atom);
    Held held = held(base.declarations().valueOf(canonical), source, fromPosition);
    set(base.declarations().variable(canonical), held);
  }

  private void exclude(Formula.Atom atom, Source source, boolean fromPosition) {
    Formula.Atom canonical = base.declarations().canonical(atom);
    StateVariable variable = base.declarations().variable(canonical);
    if (!base.declarations().isFunctional(atom.predicate())) {
      set(variable, held(new Term.Truth(false), source, fromPosition));
      return;
    }
    Held exclusion = held(base.declarations().valueOf(canonical), source, fromPosition);
    Cell cell = cell(variable).orElse(Cell.LOST);
    boolean contradicts =
        cell.value().filter(value -> value.value().equals(exclusion.value())).isPresent();
    if (contradicts && standsAgainst(cell.value(), exclusion)) {
      losers.add(new Loser(variable, exclusion, false));
    } else {
      put(variable, cell.excluding(exclusion));
    }
  }

  private void equate(Fact.Equation equation, Source source) {
    Expression.Fluent fluent = equation.fluent();
    if (equation.value() instanceof Term.Number number && !Double.isFinite(number.value())) {
      throw new KnowledgeException(
          "The value of " + fluent.name() + " is not a finite number; say (unknown ...) instead.");
    }
    set(
        new StateVariable(fluent.name(), fluent.arguments()),
        held(equation.value(), source, false));
  }

  private void set(StateVariable variable, Held held) {
    Optional<Held> present = cell(variable).flatMap(Cell::value);
    boolean differs = present.filter(p -> !p.value().equals(held.value())).isPresent();
    if (differs && standsAgainst(present, held)) {
      losers.add(new Loser(variable, held, true));
    } else if (!expectsWhatIsKnown(variable, present, held)) {
      put(variable, Cell.of(held));
    }
  }

  /** An expectation that tells nothing new does not take the place of what was seen or stated. */
  private boolean expectsWhatIsKnown(StateVariable variable, Optional<Held> present, Held held) {
    return held.source().kind() == Source.Kind.EXPECTED
        && present
            .filter(p -> p.value().equals(held.value()))
            .filter(p -> p.source().kind() != Source.Kind.EXPECTED)
            .filter(p -> base.declarations().isFresh(variable, p, now))
            .isPresent();
  }

  private boolean standsAgainst(Optional<Held> present, Held challenger) {
    return challenger.source().kind() == Source.Kind.EXPECTED
        && !(challenger.value() instanceof Term.Number)
        && present
            .filter(p -> p.source().kind() == Source.Kind.OBSERVED)
            .filter(p -> p.since().equals(challenger.since()))
            .filter(p -> !p.source().agent().equals(challenger.source().agent()))
            .isPresent();
  }

  private Held held(Term value, Source source, boolean fromPosition) {
    return new Held(value, source, now, fromPosition, serials.getAsLong());
  }

  private void put(StateVariable variable, Cell cell) {
    if (copied.add(variable.predicate())) {
      cells.put(
          variable.predicate(),
          new LinkedHashMap<>(cells.getOrDefault(variable.predicate(), Map.of())));
    }
    cells.get(variable.predicate()).put(variable.arguments(), cell);
    touched.add(variable);
  }
}
