package org.maestro.ontology.home;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/** A formula in which what is so is replaced by what is supposed to be so. Immutable. */
record Supposition(Formula.Atom known, Formula.Atom supposed) {

  /** Only atoms that the formula wants to hold: of what is denied nothing is supposed. */
  Formula of(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      return of(atom);
    } else if (formula instanceof Formula.And and) {
      return new Formula.And(all(and.operands()));
    } else if (formula instanceof Formula.Or or) {
      return new Formula.Or(all(or.operands()));
    } else if (formula instanceof Formula.Exists exists) {
      return new Formula.Exists(exists.variables(), of(exists.body()));
    }
    return formula;
  }

  private List<Formula> all(List<Formula> operands) {
    return operands.stream().map(this::of).toList();
  }

  private Formula of(Formula.Atom atom) {
    if (!atom.predicate().equals(known.predicate())
        || atom.arguments().size() != known.arguments().size()) {
      return atom;
    }
    Map<String, Term> bindings = new TreeMap<>();
    for (int i = 0; i < known.arguments().size(); i++) {
      if (known.arguments().get(i) instanceof Term.Variable variable) {
        bindings.put(variable.name(), atom.arguments().get(i));
      } else if (!known.arguments().get(i).equals(atom.arguments().get(i))) {
        return atom;
      }
    }
    return new Substitution(bindings).apply(supposed);
  }
}
