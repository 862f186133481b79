package org.maestro.coordination.facts;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/** Says formulas in the words in which facts are kept: derived predicates are spelled out. */
public final class Unfolding {
  private final Vocabulary vocabulary;

  public Unfolding(Vocabulary vocabulary) {
    this.vocabulary = vocabulary;
  }

  /** The parts that all have to hold, with their variables' values, spelled out. */
  public List<Formula> conjuncts(Formula formula, Map<String, Term> bindings) {
    List<Formula> conjuncts = new ArrayList<>();
    collect(unfolded(new Substitution(bindings).apply(formula), Set.of()), conjuncts);
    return conjuncts;
  }

  private static void collect(Formula formula, List<Formula> conjuncts) {
    if (formula instanceof Formula.And and) {
      and.operands().forEach(operand -> collect(operand, conjuncts));
    } else if (formula instanceof Formula.Keep keep) {
      collect(keep.body(), conjuncts);
    } else {
      conjuncts.add(formula);
    }
  }

  private Formula unfolded(Formula formula, Set<String> inside) {
    if (formula instanceof Formula.Atom atom) {
      return atom(atom, inside);
    } else if (formula instanceof Formula.And and) {
      return new Formula.And(and.operands().stream().map(o -> unfolded(o, inside)).toList());
    } else if (formula instanceof Formula.Or or) {
      return new Formula.Or(or.operands().stream().map(o -> unfolded(o, inside)).toList());
    } else if (formula instanceof Formula.Not not) {
      return new Formula.Not(unfolded(not.operand(), inside));
    } else if (formula instanceof Formula.Imply imply) {
      return new Formula.Imply(
          unfolded(imply.premise(), inside), unfolded(imply.conclusion(), inside));
    } else if (formula instanceof Formula.Exists exists) {
      return new Formula.Exists(exists.variables(), unfolded(exists.body(), inside));
    } else if (formula instanceof Formula.Forall forall) {
      return new Formula.Forall(forall.variables(), unfolded(forall.body(), inside));
    } else if (formula instanceof Formula.Keep keep) {
      return new Formula.Keep(unfolded(keep.body(), inside));
    }
    return formula;
  }

  private Formula atom(Formula.Atom atom, Set<String> inside) {
    PredicateDeclaration declared = vocabulary.predicates().get(atom.predicate());
    if (declared == null
        || declared.derivedWhen().isEmpty()
        || declared.parameters().size() != atom.arguments().size()
        || inside.contains(atom.predicate())) {
      return atom;
    }
    Map<String, Term> values = new LinkedHashMap<>();
    for (int i = 0; i < atom.arguments().size(); i++) {
      values.put(declared.parameters().get(i).name(), atom.arguments().get(i));
    }
    Set<String> deeper = new LinkedHashSet<>(inside);
    deeper.add(atom.predicate());
    return unfolded(new Substitution(values).apply(declared.derivedWhen().get()), deeper);
  }
}
