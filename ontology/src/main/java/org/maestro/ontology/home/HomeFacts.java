package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.OnlyKnown;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The facts that a home's file alone states: classes, stated properties, derived and computed
 * predicates. Observable facts that it does not state are unknown. Immutable.
 */
public final class HomeFacts implements Facts {

  private final Home home;
  private final Vocabulary vocabulary;
  private final Geometry geometry;
  private final Facts onlyKnown = new OnlyKnown(this);

  public HomeFacts(Home home) {
    this.home = home;
    this.vocabulary = home.vocabulary();
    this.geometry = new Geometry(home);
  }

  public Geometry geometry() {
    return geometry;
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    Optional<PredicateDeclaration> declared = vocabulary.predicate(atom.predicate());
    if (declared.isEmpty()) {
      return Truth.of(isMember(atom));
    }
    PredicateDeclaration predicate = declared.get();
    if (predicate.fluent()) {
      boolean known = number(new Expression.Fluent(atom.predicate(), atom.arguments())).isPresent();
      return known ? Truth.TRUE : Truth.UNKNOWN;
    }
    if (predicate.derivedWhen().isPresent()) {
      Facts facts = predicate.observable() ? this : onlyKnown;
      return evaluated(predicate, predicate.derivedWhen().get(), atom, facts);
    }
    if (isStated(atom)) {
      return Truth.TRUE;
    }
    if (predicate.computedBy().isPresent()) {
      return geometry.truth(predicate.computedBy().get(), atom.arguments(), Positions.UNKNOWN);
    }
    if (!predicate.observable()) {
      return Truth.FALSE;
    }
    return predicate
        .observedWhen()
        .map(formula -> evaluated(predicate, formula, atom, this))
        .orElse(Truth.UNKNOWN);
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    if (fluent.arguments().size() == 1) {
      for (Term value : stated(fluent.name(), fluent.arguments().get(0))) {
        if (value instanceof Term.Number number) {
          return OptionalDouble.of(number.value());
        }
      }
    }
    return vocabulary
        .predicate(fluent.name())
        .flatMap(PredicateDeclaration::computedBy)
        .map(function -> geometry.number(function, fluent.arguments(), Positions.UNKNOWN))
        .orElse(OptionalDouble.empty());
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    List<Term.Name> names = new ArrayList<>();
    for (Individual individual : home.individuals().values()) {
      if (className.isEmpty() || individual.classes().contains(className)) {
        names.add(new Term.Name(individual.name()));
      }
    }
    return names;
  }

  private boolean isMember(Formula.Atom atom) {
    return atom.arguments().size() == 1
        && atom.arguments().get(0) instanceof Term.Name name
        && home.individuals().containsKey(name.text())
        && home.individuals().get(name.text()).classes().contains(atom.predicate());
  }

  private boolean isStated(Formula.Atom atom) {
    List<Term> arguments = atom.arguments();
    if (arguments.size() == 1) {
      return stated(atom.predicate(), arguments.get(0)).contains(new Term.Truth(true));
    }
    return arguments.size() == 2
        && stated(atom.predicate(), arguments.get(0)).contains(arguments.get(1));
  }

  private List<Term> stated(String property, Term subject) {
    return subject instanceof Term.Name name && home.individuals().containsKey(name.text())
        ? home.individuals().get(name.text()).properties().getOrDefault(property, List.of())
        : List.of();
  }

  private static Truth evaluated(
      PredicateDeclaration predicate, Formula formula, Formula.Atom atom, Facts facts) {
    Map<String, Term> bindings = new LinkedHashMap<>();
    for (int i = 0; i < predicate.parameters().size() && i < atom.arguments().size(); i++) {
      bindings.put(predicate.parameters().get(i).name(), atom.arguments().get(i));
    }
    return new Evaluation(facts).truth(formula, bindings);
  }
}
