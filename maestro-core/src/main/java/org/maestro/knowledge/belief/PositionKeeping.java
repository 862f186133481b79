package org.maestro.knowledge.belief;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.ontology.floor.Pose;
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
public final class PositionKeeping {

  private static final Logger LOG = LoggerFactory.getLogger(PositionKeeping.class);

  private final Draft draft;
  private final Function<World, Snapshot> view;

  public PositionKeeping(Draft draft, Function<World, Snapshot> view) {
    this.draft = draft;
    this.view = view;
  }

  /**
   * Writes the positions, then what follows from them, then the rest: what is said outright has the
   * last word.
   */
  public void write(List<Fact> facts, Voice voice) {
    List<Fact> rest = new ArrayList<>();
    Set<Term> moved = new LinkedHashSet<>();
    for (Fact fact : facts) {
      if (fact instanceof Fact.Holds holds && isPosition(holds.atom())) {
        if (!isReadable(holds.atom().arguments().get(1))) {
          LOG.warn(
              "{} told {}, which is no position; it is ignored.",
              voice.source().agent(),
              SlPrinter.print(fact));
        } else if (draft.write(fact, voice)) {
          moved.add(holds.atom().arguments().get(0));
        }
      } else {
        rest.add(fact);
      }
    }
    moved.forEach(this::follow);
    Set<Fact> contradicting = new LinkedHashSet<>();
    rest.stream()
        .filter(fact -> contradictsItsPosition(fact, moved, voice))
        .forEach(contradicting::add);
    for (Fact fact : rest) {
      if (fact instanceof Fact.Unknown unknown) {
        forget(draft.variable(unknown.atom()));
      } else if (draft.write(fact, voice) && contradicting.contains(fact)) {
        dropPosition(FactReader.atom(fact).arguments().get(0));
      }
    }
    rest.forEach(fact -> withdrawWhatWasSeenWith(fact, voice));
  }

  /**
   * What a source observed of a thing together with its position, it does not observe any more: the
   * thing is not where that source saw it.
   */
  private void withdrawWhatWasSeenWith(Fact fact, Voice voice) {
    if (!(fact instanceof Fact.Excluded excluded) || voice.expects()) {
      return;
    }
    StateVariable variable = draft.variable(excluded.atom());
    Optional<Held> before =
        draft
            .base()
            .cell(variable)
            .flatMap(Cell::last)
            .filter(held -> held.value().equals(new Term.Truth(true)))
            .filter(held -> held.source().equals(voice.source()));
    for (Term thing : excluded.atom().arguments()) {
      StateVariable position = new StateVariable(Declarations.POSITION, List.of(thing));
      boolean seenWithIt =
          before.isPresent()
              && draft.cell(position).orElse(Cell.LOST).standing().stream()
                  .map(Claim::held)
                  .filter(held -> held.source().equals(voice.source()))
                  .anyMatch(held -> held.since().equals(before.get().since()));
      if (seenWithIt) {
        withdraw(position, voice.source());
      }
    }
  }

  /** Writes what follows from the thing's position as it is believed now. */
  void follow(Term thing) {
    draft
        .believed(new StateVariable(Declarations.POSITION, List.of(thing)))
        .ifPresent(
            position ->
                sightings().of(thing).stream()
                    .filter(this::isWorthWriting)
                    .forEach(fact -> draft.follow(fact, oldest(fact, position))));
  }

  /**
   * What it rests on and was told longest ago: who sees one of two things anew has not seen that
   * the other is still beside it.
   */
  private Held oldest(Fact fact, Held position) {
    return FactReader.atom(fact).arguments().stream()
        .map(thing -> draft.believed(new StateVariable(Declarations.POSITION, List.of(thing))))
        .flatMap(Optional::stream)
        .reduce(position, (a, b) -> b.since().isBefore(a.since()) ? b : a);
  }

  /**
   * What does not hold by the positions need not be written where nobody said otherwise: who asks
   * is told by the positions.
   */
  private boolean isWorthWriting(Fact fact) {
    return fact instanceof Fact.Holds
        || draft.cell(draft.variable(FactReader.atom(fact))).isPresent();
  }

  /** Forgets the variable; a position with all that followed from it. */
  public void forget(StateVariable variable) {
    forget(variable, claim -> false);
  }

  /**
   * The same, but what this source says of itself all along counts as soon as nothing else does.
   */
  public void forgetAllBut(Source source, StateVariable variable) {
    forget(variable, claim -> claim.held().source().equals(source));
  }

  private void forget(StateVariable variable, Predicate<Claim> kept) {
    draft.forget(variable, kept);
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

  /** The source does not say so any more; what others say counts then. */
  void withdraw(StateVariable variable, Source source) {
    keep(variable, claim -> !claim.held().source().equals(source));
  }

  /** What is too old does not count any more. */
  public void age(StateVariable variable, Cell cell) {
    if (cell.nextExpiry().isBefore(draft.now())) {
      boolean left = cell.standing().stream().anyMatch(this::isFresh);
      draft.keep(variable, this::isFresh);
      if (left && variable.predicate().equals(Declarations.POSITION)) {
        follow(variable.arguments().get(0));
      }
    }
  }

  private boolean isFresh(Claim claim) {
    return claim.held().isFresh(draft.now());
  }

  private void keep(StateVariable variable, Predicate<Claim> kept) {
    if (draft.cell(variable).orElse(Cell.LOST).standing().stream().noneMatch(kept)) {
      forget(variable);
      return;
    }
    draft.keep(variable, kept);
    if (variable.predicate().equals(Declarations.POSITION)) {
      forgetWhatFollowed(variable.arguments().get(0));
      follow(variable.arguments().get(0));
    }
  }

  private boolean contradictsItsPosition(Fact fact, Set<Term> moved, Voice voice) {
    boolean holds = fact instanceof Fact.Holds;
    if (!holds && !(fact instanceof Fact.Excluded)) {
      return false;
    }
    Formula.Atom atom = FactReader.atom(fact);
    return !atom.arguments().isEmpty()
        && !moved.contains(atom.arguments().get(0))
        && !isOwnWordAgainstExpectation(atom.arguments().get(0), voice)
        && contradicts(atom, holds);
  }

  /**
   * What tells its own position tells the next one too; an expectation need not take the last one
   * away.
   */
  private boolean isOwnWordAgainstExpectation(Term thing, Voice voice) {
    return voice.expects()
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
    draft
        .world()
        .cells()
        .forEach(
            (variable, cell) -> {
              if (cell.standing().stream().anyMatch(claim -> follows(variable, claim, thing))) {
                draft.keep(variable, claim -> !follows(variable, claim, thing));
              }
            });
  }

  private static boolean follows(StateVariable variable, Claim claim, Term thing) {
    return claim.held().fromPosition()
        && (claim.value().equals(thing) || variable.arguments().contains(thing));
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
