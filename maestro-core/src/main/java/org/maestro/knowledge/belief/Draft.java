package org.maestro.knowledge.belief;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.LongSupplier;
import java.util.function.Predicate;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * A write under way. Claims of several sources stand beside each other in a cell, which settles
 * what is believed. Of one instant, an observation stands against another source's expectation; the
 * expectation is kept as a loser. Expected numbers build on those observed, and do not contradict
 * them.
 */
public final class Draft {

  /** How sure it is what a step brings about: as likely as not. */
  static final double EXPECTATION = 0.5;

  private final World base;
  private final Instant now;
  private final LongSupplier serials;
  private Cells cells;
  private final Set<StateVariable> touched = new LinkedHashSet<>();
  private final List<Loser> losers = new ArrayList<>();

  /** A statement that was not even kept to stand. */
  record Loser(StateVariable variable, Claim claim) {}

  private record Speech(Voice voice, Instant since, boolean fromPosition) {}

  public Draft(World base, Instant now, LongSupplier serials) {
    this.base = base;
    this.now = now;
    this.serials = serials;
    this.cells = base.cells();
  }

  World base() {
    return base;
  }

  /** The world with what was written until now. */
  public World world() {
    return base.with(cells, base.version() + 1);
  }

  /** The first instant after which something that was touched does not count any more. */
  public Instant nextExpiry() {
    Instant earliest = Instant.MAX;
    for (StateVariable variable : touched) {
      Instant own = cell(variable).orElse(Cell.LOST).nextExpiry();
      earliest = own.isBefore(earliest) ? own : earliest;
    }
    return earliest;
  }

  Instant now() {
    return now;
  }

  public Set<StateVariable> touched() {
    return Collections.unmodifiableSet(touched);
  }

  List<Loser> losers() {
    return List.copyOf(losers);
  }

  Optional<Cell> cell(StateVariable variable) {
    return cells.get(variable);
  }

  /** Returns whether it is believed now. */
  boolean write(Fact fact, Voice voice) {
    return write(fact, new Speech(voice, now, false));
  }

  /** Writes what follows from a position that is believed. */
  void follow(Fact fact, Held position) {
    write(
        fact,
        new Speech(new Voice(position.source(), position.confidence()), position.since(), true));
  }

  private boolean write(Fact fact, Speech speech) {
    if (fact instanceof Fact.Holds holds) {
      Formula.Atom atom = base.declarations().canonical(holds.atom());
      return set(base.declarations().variable(atom), base.declarations().valueOf(atom), speech);
    } else if (fact instanceof Fact.Excluded excluded) {
      return exclude(base.declarations().canonical(excluded.atom()), speech);
    } else if (fact instanceof Fact.Equation equation) {
      return equate(equation, speech);
    }
    forget(variable(((Fact.Unknown) fact).atom()));
    return true;
  }

  /** What was known of the variable is not known any more; exclusions go too. */
  void forget(StateVariable variable) {
    forget(variable, claim -> false);
  }

  /**
   * @param kept claims that were overruled and may count again if their source says so still
   */
  void forget(StateVariable variable, Predicate<Claim> kept) {
    Optional<Cell> cell = cell(variable);
    if (cell.filter(c -> !c.isLost()).isPresent()
        || cell.isEmpty() && base.described().describes(variable)) {
      put(variable, cell.orElse(Cell.LOST).lostBut(kept));
    }
  }

  /** Keeps only those claims on the variable for which this holds. */
  void keep(StateVariable variable, Predicate<Claim> kept) {
    cell(variable)
        .ifPresent(
            cell -> {
              Cell less = cell.only(kept);
              if (!less.equals(cell)) {
                put(variable, less);
              }
            });
  }

  /** Of what was touched, what is said all along counts where nothing else does any more. */
  public void goOn(BiPredicate<StateVariable, Claim> stillSaid) {
    for (StateVariable variable : List.copyOf(touched)) {
      Cell cell = cell(variable).orElse(Cell.LOST);
      Cell again = cell.goingOn(claim -> stillSaid.test(variable, claim), now);
      if (again != cell) {
        put(variable, again);
      }
    }
  }

  public StateVariable variable(Formula.Atom atom) {
    return base.declarations().spokenOf(atom);
  }

  private boolean exclude(Formula.Atom atom, Speech speech) {
    StateVariable variable = base.declarations().variable(atom);
    if (!base.declarations().isFunctional(atom.predicate())) {
      return set(variable, new Term.Truth(false), speech);
    }
    Term value = base.declarations().valueOf(atom);
    Claim claim =
        new Claim(held(variable, value, false, speech, speech.voice().confidence()), false);
    boolean contradicts =
        believed(variable).filter(present -> present.value().equals(value)).isPresent();
    if (contradicts && standsAgainst(believed(variable), claim.held())) {
      losers.add(new Loser(variable, claim));
      return false;
    }
    return put(variable, claim);
  }

  private boolean equate(Fact.Equation equation, Speech speech) {
    Expression.Fluent fluent = FactReader.finite(equation).fluent();
    return set(new StateVariable(fluent.name(), fluent.arguments()), equation.value(), speech);
  }

  private boolean set(StateVariable variable, Term value, Speech speech) {
    Optional<Held> present = believed(variable);
    Held held = held(variable, value, true, speech, confidence(speech.voice(), present));
    boolean differs = present.filter(p -> !p.value().equals(value)).isPresent();
    if (differs && standsAgainst(present, held)) {
      losers.add(new Loser(variable, new Claim(held, true)));
      return false;
    }
    return expectsWhatIsKnown(present, held) || put(variable, new Claim(held, true));
  }

  /** What is reckoned forward is no surer than what it was reckoned from, and never sure. */
  private static double confidence(Voice voice, Optional<Held> present) {
    return voice.expects()
        ? Math.min(
            Math.min(EXPECTATION, voice.confidence()), present.map(Held::confidence).orElse(1.0))
        : voice.confidence();
  }

  /** An expectation that tells nothing new does not take the place of what was seen or stated. */
  private static boolean expectsWhatIsKnown(Optional<Held> present, Held held) {
    return held.isExpected()
        && present
            .filter(p -> p.value().equals(held.value()))
            .filter(p -> !p.isExpected())
            .isPresent();
  }

  private static boolean standsAgainst(Optional<Held> present, Held challenger) {
    return challenger.isExpected()
        && !challenger.isNumber()
        && present
            .filter(p -> p.source().kind() == Source.Kind.OBSERVED)
            .filter(p -> p.since().equals(challenger.since()))
            .filter(p -> !p.source().agent().equals(challenger.source().agent()))
            .isPresent();
  }

  /** The value that is believed now. */
  Optional<Held> believed(StateVariable variable) {
    return cell(variable).flatMap(cell -> cell.settled(held -> held.isFresh(now)).value());
  }

  private Held held(
      StateVariable variable, Term value, boolean has, Speech speech, double confidence) {
    Source source = speech.voice().source();
    Instant expires = base.declarations().expires(variable, value, source, speech.since());
    Optional<Held> before =
        cell(variable)
            .flatMap(cell -> cell.claim(source, value, has))
            .filter(held -> held.isRepeatedBy(speech.since(), expires));
    return new Held(
        value,
        source,
        speech.since(),
        expires,
        before.map(Held::noted).orElse(speech.since()),
        confidence,
        speech.fromPosition(),
        speech.voice().coveredShare(),
        before.map(Held::serial).orElseGet(serials::getAsLong));
  }

  private boolean put(StateVariable variable, Claim claim) {
    Cell cell = cell(variable).orElse(Cell.LOST).with(claim, now);
    put(variable, cell);
    return !cell.settled().losers().contains(claim);
  }

  private void put(StateVariable variable, Cell cell) {
    cells = cells.with(variable, cell);
    touched.add(variable);
  }
}
