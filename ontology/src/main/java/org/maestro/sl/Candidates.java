package org.maestro.sl;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * The individuals for which a formula can hold, as far as an index tells: all others need not be
 * tried. In a building a zone has a handful of doors, and {@code (exists (?d - Door) (and (side ?d
 * zone-a) ...))} looks at those alone. As safe for threads as the index is.
 */
public final class Candidates {

  /** The individuals of which an atom may be true, found without trying each. */
  public interface Index {
    /**
     * The individuals that may stand for the variable.
     *
     * @param atom ground but for the variable, which stands in it once
     * @param variable its name, without question mark
     * @return at least all for which the atom is not false; empty when that is not known
     */
    Optional<Set<Term>> candidates(Formula.Atom atom, String variable);

    /**
     * The individuals that may stand for the variable where a number is to be more than zero.
     *
     * @param fluent ground but for the variable, which stands in it once
     * @param variable its name, without question mark
     * @return at least all for which the number is not known to be zero or less; empty when that is
     *     not known
     */
    default Optional<Set<Term>> aboveZero(Expression.Fluent fluent, String variable) {
      return Optional.empty();
    }
  }

  private final Index index;

  public Candidates(Index index) {
    this.index = index;
  }

  /**
   * The individuals that may stand for a free variable of the formula.
   *
   * @param holding whether the formula is to hold; otherwise it is not to
   * @param variable its name, without question mark
   * @param bindings values of other variables; those of which nothing stands here are open
   * @return at least all with which it may be so; empty when all have to be tried
   */
  public Optional<Set<Term>> of(
      Formula formula, boolean holding, String variable, Map<String, Term> bindings) {
    if (formula instanceof Formula.Atom atom) {
      return holding ? ofAtom(atom, variable, bindings) : Optional.empty();
    } else if (formula instanceof Formula.Not not) {
      return of(not.operand(), !holding, variable, bindings);
    } else if (formula instanceof Formula.Imply imply) {
      Formula contrary = new Formula.Not(imply.premise());
      return joined(List.of(contrary, imply.conclusion()), !holding, holding, variable, bindings);
    } else if (formula instanceof Formula.And and) {
      return joined(and.operands(), holding, holding, variable, bindings);
    } else if (formula instanceof Formula.Or or) {
      return joined(or.operands(), !holding, holding, variable, bindings);
    } else if (formula instanceof Formula.Exists exists) {
      return holding
          ? forSome(exists.variables(), exists.body(), true, variable, bindings)
          : Optional.empty();
    } else if (formula instanceof Formula.Forall forall) {
      return holding
          ? Optional.empty()
          : forSome(forall.variables(), forall.body(), false, variable, bindings);
    } else if (formula instanceof Formula.Comparison comparison) {
      return holding
          ? ofEquality(comparison, variable, bindings)
              .or(() -> ofPositive(comparison, variable, bindings))
          : Optional.empty();
    }
    return Optional.empty();
  }

  private Optional<Set<Term>> ofAtom(
      Formula.Atom atom, String variable, Map<String, Term> bindings) {
    return open(atom.arguments(), variable, bindings)
        .flatMap(open -> index.candidates(new Formula.Atom(atom.predicate(), open), variable));
  }

  /** What is more than something from zero on is more than zero. */
  private Optional<Set<Term>> ofPositive(
      Formula.Comparison comparison, String variable, Map<String, Term> bindings) {
    Expression more = comparison.left();
    Expression less = comparison.right();
    boolean orEqual = comparison.relation() == Formula.Relation.AT_LEAST;
    switch (comparison.relation()) {
      case GREATER, AT_LEAST -> {}
      case LESS, AT_MOST -> {
        more = comparison.right();
        less = comparison.left();
        orEqual = comparison.relation() == Formula.Relation.AT_MOST;
      }
      case EQUAL -> {
        return Optional.empty();
      }
    }
    boolean isPositive =
        less instanceof Expression.OfTerm of
            && of.term() instanceof Term.Number number
            && (orEqual ? number.value() > 0 : number.value() >= 0);
    return isPositive && more instanceof Expression.Fluent fluent
        ? open(fluent.arguments(), variable, bindings)
            .flatMap(open -> index.aboveZero(new Expression.Fluent(fluent.name(), open), variable))
        : Optional.empty();
  }

  /** The arguments, ground but for the variable; empty when it is not the only one that is open. */
  private static Optional<List<Term>> open(
      List<Term> given, String variable, Map<String, Term> bindings) {
    Term[] arguments = new Term[given.size()];
    int places = 0;
    for (int i = 0; i < arguments.length; i++) {
      Term argument = given.get(i);
      if (argument instanceof Term.Variable named) {
        if (named.name().equals(variable)) {
          places++;
        } else {
          argument = bindings.get(named.name());
          if (argument == null) {
            return Optional.empty();
          }
        }
      }
      arguments[i] = argument;
    }
    return places == 1 ? Optional.of(List.of(arguments)) : Optional.empty();
  }

  /**
   * @param all whether all parts have to be so, or one of them
   */
  private Optional<Set<Term>> joined(
      List<Formula> parts,
      boolean all,
      boolean holding,
      String variable,
      Map<String, Term> bindings) {
    Optional<Set<Term>> narrowest = Optional.empty();
    Set<Term> some = new LinkedHashSet<>();
    for (Formula part : parts) {
      Optional<Set<Term>> own = of(part, holding, variable, bindings);
      if (!all && own.isEmpty()) {
        return Optional.empty();
      }
      if (own.isPresent() && (narrowest.isEmpty() || own.get().size() < narrowest.get().size())) {
        narrowest = own;
      }
      own.ifPresent(some::addAll);
    }
    return all ? narrowest : Optional.of(some);
  }

  private Optional<Set<Term>> forSome(
      List<TypedVariable> quantified,
      Formula body,
      boolean holding,
      String variable,
      Map<String, Term> bindings) {
    Map<String, Term> inside = new HashMap<>(bindings);
    for (TypedVariable inner : quantified) {
      if (inner.name().equals(variable)) {
        return Optional.empty();
      }
      inside.remove(inner.name());
    }
    Optional<Set<Term>> whoever = of(body, holding, variable, inside);
    if (whoever.isPresent() || quantified.size() > 1) {
      return whoever;
    }
    String inner = quantified.get(0).name();
    Optional<Set<Term>> among = of(body, holding, inner, inside);
    if (among.isEmpty()) {
      return Optional.empty();
    }
    Set<Term> some = new HashSet<>();
    for (Term individual : among.get()) {
      inside.put(inner, individual);
      Optional<Set<Term>> own = of(body, holding, variable, inside);
      if (own.isEmpty()) {
        return Optional.empty();
      }
      some.addAll(own.get());
    }
    return Optional.of(some);
  }

  private static Optional<Set<Term>> ofEquality(
      Formula.Comparison comparison, String variable, Map<String, Term> bindings) {
    if (comparison.relation() != Formula.Relation.EQUAL
        || !(comparison.left() instanceof Expression.OfTerm left)
        || !(comparison.right() instanceof Expression.OfTerm right)) {
      return Optional.empty();
    }
    Term itself = new Term.Variable(variable);
    Term other =
        left.term().equals(itself)
            ? right.term()
            : right.term().equals(itself) ? left.term() : itself;
    if (other instanceof Term.Variable named && !other.equals(itself)) {
      other = bindings.getOrDefault(named.name(), itself);
    }
    return other instanceof Term.Name ? Optional.of(Set.of(other)) : Optional.empty();
  }
}
