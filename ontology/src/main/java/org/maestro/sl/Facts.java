package org.maestro.sl;

import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;

/**
 * The state over which formulas are evaluated. All atoms and fluents given to it are ground.
 * Implementations resolve derived and computed predicates themselves.
 */
public interface Facts {

  /** Class membership included: {@code (Thing Cup)}. */
  Truth truth(Formula.Atom atom);

  /** The number, or empty when unknown. */
  OptionalDouble number(Expression.Fluent fluent);

  /**
   * The chance, 0 to 1, that an atom whose truth is unknown holds still, since it was known to hold
   * before; 0 when it never was, or has been found not to hold since.
   */
  default double chanceStill(Formula.Atom atom) {
    return 0;
  }

  /**
   * The same facts, which tell on what each answer rests: state variables or the like, to be looked
   * for in what {@link #changedSince} says. Of the chance that something holds still they tell
   * nothing.
   *
   * @param told is called during each question, on the caller's thread
   * @return empty when these facts cannot tell
   */
  default Optional<Facts> tracing(Consumer<Object> told) {
    return Optional.empty();
  }

  /**
   * On what an answer must rest so that it may be another than in the other facts. All individuals
   * are the same.
   *
   * @return empty when that cannot be said
   */
  default Optional<Set<Object>> changedSince(Facts other) {
    return Optional.empty();
  }

  /**
   * The terms with which an atom may hold, where these facts can tell that without trying each.
   *
   * @param atom ground but for the variable, which stands in it once
   * @param variable its name, without question mark
   * @return at least all with which the atom is not false, numbers and texts too; empty when all
   *     have to be tried
   */
  default Optional<Set<Term>> candidates(Formula.Atom atom, String variable) {
    return Optional.empty();
  }

  /**
   * The terms with which a number may be more than zero, where these facts can tell that without
   * that each is asked for.
   *
   * @param fluent ground but for the variable, which stands in it once
   * @param variable its name, without question mark
   * @return at least all with which the number is not known to be zero or less; empty when all have
   *     to be tried
   */
  default Optional<Set<Term>> aboveZero(Expression.Fluent fluent, String variable) {
    return Optional.empty();
  }

  /**
   * Those of the individuals of which the very same is known, so that what can be done with one of
   * them can be done with each other in its place.
   *
   * @return sets of two at least, in the order of the individuals; none where these facts cannot
   *     tell
   */
  default List<List<Term.Name>> alike(Collection<Term.Name> individuals) {
    return List.of();
  }

  /**
   * The individuals of a class, subclasses included, in a stable order; of all classes when the
   * name is "".
   */
  Collection<Term.Name> individuals(String className);
}
