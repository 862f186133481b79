package org.maestro.knowledge;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.maestro.ontology.home.Pose;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Keeps positions and what follows from them in step: a new position decides its {@code
 * observedWhen} facts anew, a fact that contradicts a position drops it, and with a position goes
 * what followed from it.
 */
final class PositionKeeping {

  private static final Logger LOG = LoggerFactory.getLogger(PositionKeeping.class);

  private final Draft draft;
  private final Function<World, Snapshot> view;

  PositionKeeping(Draft draft, Function<World, Snapshot> view) {
    this.draft = draft;
    this.view = view;
  }

  /**
   * Writes the positions, then what follows from them, then the rest: what is said outright has the
   * last word.
   */
  void write(List<Fact> facts, Source source) {
    List<Fact> rest = new ArrayList<>();
    Set<Term> moved = new LinkedHashSet<>();
    for (Fact fact : facts) {
      if (fact instanceof Fact.Holds holds && isPosition(holds.atom())) {
        if (isReadable(holds.atom().arguments().get(1))) {
          draft.write(fact, source, false);
          moved.add(holds.atom().arguments().get(0));
        } else {
          LOG.warn(
              "{} told {}, which is no position; it is ignored.",
              source.agent(),
              SlPrinter.print(fact));
        }
      } else {
        rest.add(fact);
      }
    }
    for (Term thing : moved) {
      for (Fact fact : sightings().of(thing)) {
        draft.write(fact, source, true);
      }
    }
    rest.forEach(fact -> dropContradicted(fact, moved, source));
    for (Fact fact : rest) {
      if (fact instanceof Fact.Unknown unknown) {
        forget(draft.variable(unknown.atom()));
      } else {
        draft.write(fact, source, false);
      }
    }
  }

  /** Forgets the variable; a position with all that followed from it. */
  void forget(StateVariable variable) {
    draft.forget(variable);
    variable.arguments().stream()
        .findFirst()
        .ifPresent(
            subject -> {
              if (variable.predicate().equals(Declarations.POSITION)) {
                forgetWhatFollowed(subject);
              } else if (isFromItsPosition(variable)) {
                dropPosition(subject);
              }
            });
  }

  private void dropContradicted(Fact fact, Set<Term> moved, Source source) {
    boolean holds = fact instanceof Fact.Holds;
    Optional<Formula.Atom> said =
        holds
            ? Optional.of(((Fact.Holds) fact).atom())
            : fact instanceof Fact.Excluded excluded
                ? Optional.of(excluded.atom())
                : Optional.empty();
    said.filter(atom -> !atom.arguments().isEmpty())
        .filter(atom -> !moved.contains(atom.arguments().get(0)))
        .filter(atom -> !isOwnWordAgainstExpectation(atom.arguments().get(0), source))
        .filter(atom -> contradicts(atom, holds))
        .ifPresent(atom -> dropPosition(atom.arguments().get(0)));
  }

  /**
   * What tells its own position tells the next one too; an expectation need not take the last one
   * away.
   */
  private boolean isOwnWordAgainstExpectation(Term thing, Source source) {
    return source.kind() == Source.Kind.EXPECTED
        && thing instanceof Term.Name name
        && draft
            .cell(new StateVariable(Declarations.POSITION, List.of(thing)))
            .flatMap(Cell::value)
            .filter(held -> held.source().equals(new Source(Source.Kind.STATED, name.text())))
            .isPresent();
  }

  private boolean contradicts(Formula.Atom atom, boolean holds) {
    Truth decided = sightings().decided(atom);
    if (decided != Truth.UNKNOWN) {
      return decided != Truth.of(holds);
    }
    Term value = draft.base().declarations().valueOf(atom);
    return holds
        && draft.base().declarations().isFunctional(atom.predicate())
        && draft
            .cell(draft.variable(atom))
            .flatMap(Cell::value)
            .filter(held -> held.fromPosition() && !held.value().equals(value))
            .isPresent();
  }

  private void dropPosition(Term thing) {
    StateVariable position = new StateVariable(Declarations.POSITION, List.of(thing));
    if (draft.cell(position).flatMap(Cell::value).isPresent()) {
      draft.forget(position);
      forgetWhatFollowed(thing);
    }
  }

  private void forgetWhatFollowed(Term thing) {
    for (StateVariable variable : draft.world().variables()) {
      Cell cell = draft.cell(variable).orElseThrow();
      boolean about = variable.arguments().contains(thing);
      cell.value()
          .filter(Held::fromPosition)
          .filter(held -> about || held.value().equals(thing))
          .ifPresent(held -> draft.forget(variable));
      cell.excluded().values().stream()
          .filter(Held::fromPosition)
          .filter(held -> about || held.value().equals(thing))
          .forEach(held -> draft.readmit(variable, held.value()));
    }
  }

  private Sightings sightings() {
    World world = draft.world();
    return new Sightings(world, view.apply(world));
  }

  /**
   * The value of a functional predicate tells where its first argument is; other atoms may be about
   * another thing's move.
   */
  private boolean isFromItsPosition(StateVariable variable) {
    return draft.base().declarations().isFunctional(variable.predicate())
        && draft.base().cell(variable).flatMap(Cell::value).filter(Held::fromPosition).isPresent();
  }

  private static boolean isReadable(Term position) {
    if (!(position instanceof Term.Text text)) {
      return false;
    }
    try {
      Pose.parse(text.value());
      return true;
    } catch (IllegalArgumentException e) {
      return false;
    }
  }

  private static boolean isPosition(Formula.Atom atom) {
    return atom.predicate().equals(Declarations.POSITION) && atom.arguments().size() == 2;
  }
}
