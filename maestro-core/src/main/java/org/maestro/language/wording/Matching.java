package org.maestro.language.wording;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/** What stands in a formula where a pattern has variables. Bound to one formula. */
final class Matching {
  private final Map<String, Term> bound = new HashMap<>();

  private Matching() {}

  /** By the variable's name; empty when the formula is not made like the pattern. */
  static Optional<Map<String, Term>> of(Formula pattern, Formula formula) {
    Matching matching = new Matching();
    return matching.fits(pattern, formula) ? Optional.of(Map.copyOf(matching.bound)) : none();
  }

  private static Optional<Map<String, Term>> none() {
    return Optional.empty();
  }

  private boolean fits(Formula pattern, Formula formula) {
    if (pattern instanceof Formula.Atom wanted && formula instanceof Formula.Atom atom) {
      return wanted.predicate().equals(atom.predicate())
          && fits(wanted.arguments(), atom.arguments());
    } else if (pattern instanceof Formula.Comparison wanted
        && formula instanceof Formula.Comparison comparison) {
      return wanted.relation() == comparison.relation()
          && fits(wanted.left(), comparison.left())
          && fits(wanted.right(), comparison.right());
    } else if (pattern instanceof Formula.Exists wanted && formula instanceof Formula.Exists it) {
      // How they are called is all the same, and of which class what is found turns out to be, too.
      return wanted.variables().size() == it.variables().size() && fits(wanted.body(), it.body());
    }
    boolean isSameKind =
        pattern.getClass() == formula.getClass()
            && (pattern instanceof Formula.And
                || pattern instanceof Formula.Not
                || pattern instanceof Formula.Keep);
    if (!isSameKind || pattern.parts().size() != formula.parts().size()) {
      return false;
    }
    for (int i = 0; i < pattern.parts().size(); i++) {
      if (!fits(pattern.parts().get(i), formula.parts().get(i))) {
        return false;
      }
    }
    return true;
  }

  private boolean fits(List<Term> pattern, List<Term> terms) {
    if (pattern.size() != terms.size()) {
      return false;
    }
    for (int i = 0; i < pattern.size(); i++) {
      if (!fits(pattern.get(i), terms.get(i))) {
        return false;
      }
    }
    return true;
  }

  private boolean fits(Expression pattern, Expression expression) {
    if (pattern instanceof Expression.OfTerm wanted
        && expression instanceof Expression.OfTerm term) {
      return fits(wanted.term(), term.term());
    } else if (pattern instanceof Expression.Fluent wanted
        && expression instanceof Expression.Fluent fluent) {
      return wanted.name().equals(fluent.name()) && fits(wanted.arguments(), fluent.arguments());
    }
    return pattern.equals(expression);
  }

  private boolean fits(Term pattern, Term term) {
    if (!(pattern instanceof Term.Variable variable)) {
      return pattern.equals(term);
    }
    Term before = bound.putIfAbsent(variable.name(), term);
    return before == null || before.equals(term);
  }
}
