package org.maestro.diary;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/**
 * The facts of a home that a diary keeps: in which zone a person is, and what devices are at, as
 * features set it. What comes and goes with each second is left to the charts: positions, who sees
 * whom, and numbers that are measured. Immutable.
 */
final class Noteworthy {
  private static final String PERSON = "Person";
  private static final List<String> PLACES = List.of("Zone", "Room");

  private final Home home;

  /** What features make so, and which numbers they set to what is asked of them. */
  private final Set<String> set = new TreeSet<>();

  /**
   * @param home whose words and things they speak of
   */
  Noteworthy(Home home) {
    this.home = home;
    home.devices()
        .values()
        .forEach(device -> device.features().forEach(feature -> add(feature.effect())));
  }

  private void add(Effect effect) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(this::add);
    } else if (effect instanceof Effect.When when) {
      add(when.effect());
    } else if (effect instanceof Effect.Forall forall) {
      add(forall.effect());
    } else if (effect instanceof Effect.Add added) {
      set.add(added.atom().predicate());
    } else if (effect instanceof Effect.Delete deleted) {
      set.add(deleted.atom().predicate());
    } else if (effect instanceof Effect.Change change
        && change.assignment() == Effect.Assignment.ASSIGN
        && change.value() instanceof Expression.OfTerm value
        && value.term() instanceof Term.Variable) {
      Expression.Fluent fluent = change.fluent();
      set.add(fluent.name());
    }
  }

  /** Whether the home is the one that this was made of. */
  @SuppressWarnings("ReferenceEquality") // A home that changes is another one.
  boolean isOf(Home other) {
    return home == other;
  }

  /** Whether the fact is kept. */
  boolean is(Fact fact) {
    return whereabouts(fact).isPresent() || isState(fact);
  }

  /** Empty: it is no fact of this language. */
  static Optional<Fact> read(String text) {
    try {
      return Optional.of(SlParser.fact(text));
    } catch (SlSyntaxException unreadable) {
      return Optional.empty();
    }
  }

  /** A person, and a zone in which she is, is not, or is not known to be any more. */
  record Whereabouts(String person, String zone) {}

  Optional<Whereabouts> whereabouts(Fact fact) {
    return atom(fact)
        .filter(atom -> atom.arguments().size() == 2)
        .filter(atom -> declared(atom.predicate()).filter(it -> it.functional()).isPresent())
        .filter(atom -> isA(atom.arguments().get(0), List.of(PERSON)))
        .filter(atom -> isA(atom.arguments().get(1), PLACES))
        .map(atom -> new Whereabouts(name(atom.arguments().get(0)), name(atom.arguments().get(1))));
  }

  private static String name(Term term) {
    return ((Term.Name) term).text();
  }

  private boolean isA(Term term, List<String> classes) {
    return term instanceof Term.Name name
        && Optional.ofNullable(home.individuals().get(name.text()))
            .filter(one -> classes.stream().anyMatch(one.classes()::contains))
            .isPresent();
  }

  /** That something is not known any more is no state. */
  private boolean isState(Fact fact) {
    if (fact instanceof Fact.Equation equation) {
      Expression.Fluent fluent = equation.fluent();
      return equation.value() instanceof Term.Number && set.contains(fluent.name());
    } else if (fact instanceof Fact.Holds holds) {
      return isOfOne(holds.atom())
          || set.contains(holds.atom().predicate())
              && !isObservable(holds.atom().predicate())
              && isDevice(holds.atom().arguments())
              && holds.atom().arguments().stream().allMatch(Term.Name.class::isInstance);
    }
    // What else something does not show, as it shows something, is no news.
    return fact instanceof Fact.Excluded excluded && isOfOne(excluded.atom());
  }

  private boolean isOfOne(Formula.Atom atom) {
    return atom.arguments().size() == 1
        && (set.contains(atom.predicate()) || isDevice(atom.arguments()));
  }

  private boolean isDevice(List<Term> arguments) {
    return !arguments.isEmpty()
        && arguments.get(0) instanceof Term.Name name
        && home.devices().containsKey(name.text());
  }

  private boolean isObservable(String word) {
    return declared(word).filter(PredicateDeclaration::observable).isPresent();
  }

  private Optional<PredicateDeclaration> declared(String word) {
    return home.vocabulary().predicate(word);
  }

  /** The state variable of which it tells: of what takes one value at a time, without the value. */
  String subject(Fact fact) {
    if (fact instanceof Fact.Equation equation) {
      Expression.Fluent fluent = equation.fluent();
      return fluent.name() + " " + fluent.arguments();
    }
    Formula.Atom atom = atom(fact).orElseThrow();
    int arguments = atom.arguments().size();
    boolean hasValue =
        arguments > 1 && declared(atom.predicate()).filter(it -> it.functional()).isPresent();
    return atom.predicate()
        + " "
        + atom.arguments().subList(0, hasValue ? arguments - 1 : arguments);
  }

  static Optional<Formula.Atom> atom(Fact fact) {
    if (fact instanceof Fact.Holds holds) {
      return Optional.of(holds.atom());
    } else if (fact instanceof Fact.Excluded excluded) {
      return Optional.of(excluded.atom());
    }
    return fact instanceof Fact.Unknown unknown ? Optional.of(unknown.atom()) : Optional.empty();
  }
}
