package org.maestro.knowledge.belief;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.Geometry;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Positions;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The facts as they would be if a statement that is not believed were believed, such as one that
 * lost against a surer source's: what it says itself, and what an observation of the place that it
 * names would tell. Immutable.
 */
public final class AsClaimed implements Facts {
  private final Snapshot now;
  private final Vocabulary vocabulary;
  private final Geometry geometry;
  private final Formula claimed;

  /**
   * @param claim a fact that a member states or observes
   */
  public AsClaimed(Snapshot now, Home home, Belief claim) {
    this.now = now;
    this.vocabulary = home.vocabulary();
    this.geometry = new Geometry(home);
    this.claimed = SlParser.formula(claim.fact(), home.vocabulary()::isFluent);
  }

  /** Whether the claim says of the ground atom, directly or by what it is observed from. */
  public boolean contradicts(Formula.Atom atom) {
    if (truth(atom) == Truth.FALSE) {
      return true;
    }
    return vocabulary
        .predicate(atom.predicate())
        .filter(declared -> declared.parameters().size() == atom.arguments().size())
        .filter(declared -> claims(Declarations.POSITION).isPresent())
        .flatMap(declared -> declared.observedWhen().map(when -> isFalse(declared, when, atom)))
        .orElse(false);
  }

  /**
   * What the claim makes of the ground atom, directly or by what it is observed from; unknown when
   * it says nothing of it.
   */
  public Truth tells(Formula.Atom atom) {
    if (claimed.equals(atom)) {
      return Truth.TRUE;
    }
    if (claimed.equals(new Formula.Not(atom)) || isAnotherValue(atom)) {
      return Truth.FALSE;
    }
    return vocabulary
        .predicate(atom.predicate())
        .filter(declared -> declared.parameters().size() == atom.arguments().size())
        .filter(declared -> claims(Declarations.POSITION).isPresent())
        .flatMap(declared -> declared.observedWhen().map(when -> observed(declared, when, atom)))
        .orElse(Truth.UNKNOWN);
  }

  private boolean isFalse(PredicateDeclaration declared, Formula when, Formula.Atom atom) {
    return observed(declared, when, atom) == Truth.FALSE;
  }

  private Truth observed(PredicateDeclaration declared, Formula when, Formula.Atom atom) {
    Map<String, Term> bindings = new TreeMap<>();
    for (int n = 0; n < atom.arguments().size(); n++) {
      bindings.put(declared.parameters().get(n).name(), atom.arguments().get(n));
    }
    return new Evaluation(this).truth(when, bindings);
  }

  /** The atom that is said to hold, if it is of that predicate. */
  private Optional<Formula.Atom> claims(String predicate) {
    return claimed instanceof Formula.Atom atom && atom.predicate().equals(predicate)
        ? Optional.of(atom)
        : Optional.empty();
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    if (claimed.equals(atom)) {
      return Truth.TRUE;
    }
    if (claimed.equals(new Formula.Not(atom)) || isAnotherValue(atom)) {
      return Truth.FALSE;
    }
    Optional<String> function =
        vocabulary.predicate(atom.predicate()).flatMap(PredicateDeclaration::computedBy);
    return function.filter(Geometry::isTruth).isPresent() && isOutlined(atom.arguments())
        ? geometry.truth(function.get(), atom.arguments(), positions())
        : now.truth(atom);
  }

  private boolean isAnotherValue(Formula.Atom atom) {
    List<Term> arguments = atom.arguments();
    return vocabulary
            .predicate(atom.predicate())
            .filter(PredicateDeclaration::functional)
            .isPresent()
        && claims(atom.predicate())
            .filter(said -> said.arguments().size() == arguments.size())
            .filter(
                said ->
                    said.arguments()
                        .subList(0, arguments.size() - 1)
                        .equals(arguments.subList(0, arguments.size() - 1)))
            .isPresent();
  }

  /** A place without outline is a carrier, of which no position tells what is in it. */
  private boolean isOutlined(List<Term> arguments) {
    return arguments.size() > 1
        && arguments.get(1) instanceof Term.Name place
        && geometry.outline(place.text()).isPresent();
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    if (claimed instanceof Formula.Comparison equation && equation.left().equals(fluent)) {
      return new Evaluation(now).number(equation.right(), Map.of());
    }
    Optional<String> function =
        vocabulary.predicate(fluent.name()).flatMap(PredicateDeclaration::computedBy);
    return function.filter(Geometry::isNumber).isPresent() && now.belief(fluent).isEmpty()
        ? geometry.number(function.get(), fluent.arguments(), positions())
        : now.number(fluent);
  }

  private Positions positions() {
    return name -> {
      Term thing = new Term.Name(name);
      return claims(Declarations.POSITION)
          .filter(said -> said.arguments().get(0).equals(thing))
          .map(said -> said.arguments().get(1))
          .or(() -> now.value(Declarations.POSITION, List.of(thing)))
          .filter(Term.Text.class::isInstance)
          .map(text -> Pose.parse(((Term.Text) text).value()));
    };
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return now.individuals(className);
  }
}
