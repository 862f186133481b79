package org.maestro.ontology.home;

import java.util.Collection;
import java.util.List;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * What can be seen of a thing by itself: at which one of several it is, and what is so of it alone.
 * How it stands to others is theirs as well, and is not looked for.
 */
public final class Sights {
  private final Vocabulary vocabulary;

  public Sights(Vocabulary vocabulary) {
    this.vocabulary = vocabulary;
  }

  /**
   * Goals, each reached as soon as one of these is known of the thing.
   *
   * @param names predicates and numbers that count
   */
  public List<Formula> of(Individual thing, Collection<String> names) {
    Term name = new Term.Name(thing.name());
    return of(className -> thing.classes().contains(className))
        .filter(declared -> names.contains(declared.name()))
        .map(declared -> known(declared, name))
        .toList();
  }

  /** Whether there is any of what may be of this class. */
  boolean mayBeOf(String className) {
    return of(wanted -> vocabulary.mayBeBoth(className, wanted)).findAny().isPresent();
  }

  /** The same of a thing. */
  boolean areOf(Individual thing) {
    return of(className -> thing.classes().contains(className)).findAny().isPresent();
  }

  private Stream<PredicateDeclaration> of(Predicate<String> fits) {
    return vocabulary.predicates().values().stream()
        .filter(PredicateDeclaration::observable)
        .filter(declared -> declared.parameters().size() == (isWhere(declared) ? 2 : 1))
        .filter(declared -> declared.parameters().get(0).className().filter(fits).isPresent());
  }

  private static boolean isWhere(PredicateDeclaration declared) {
    return declared.functional() && !declared.fluent();
  }

  private static Formula known(PredicateDeclaration declared, Term thing) {
    if (declared.fluent()) {
      return new Formula.Not(
          new Formula.UnknownNumber(new Expression.Fluent(declared.name(), List.of(thing))));
    } else if (isWhere(declared)) {
      TypedVariable other = declared.parameters().get(1);
      return new Formula.Exists(
          List.of(other),
          new Formula.Atom(declared.name(), List.of(thing, new Term.Variable(other.name()))));
    }
    return new Formula.Not(
        new Formula.UnknownAtom(new Formula.Atom(declared.name(), List.of(thing))));
  }
}
