package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Unavailable;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The facts as they would be known if members were there that are not. Nobody knows now how they
 * are set and where they stand. For the question whether they could help, a setting is taken to be
 * at the first of its values, and a place to be the one where the member was known last, else the
 * first that there is.
 */
public final class Returned implements Facts {

  private record State(String predicate, List<Term> arguments) {}

  private final Facts before;
  private final Map<Expression.Fluent, Double> settings = new LinkedHashMap<>();
  private final Map<State, Term> places = new LinkedHashMap<>();

  public Returned(Facts before, Vocabulary vocabulary, List<Unavailable> members) {
    this.before = before;
    for (Unavailable member : members) {
      collect(member.feature(), member.feature().type().effect(), vocabulary);
    }
  }

  private void collect(PricedFeature feature, Effect effect, Vocabulary vocabulary) {
    Term self = new Term.Name(feature.member());
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> collect(feature, part, vocabulary));
    } else if (effect instanceof Effect.Change change
        && isOfSelf(change.fluent().arguments(), 1)
        && change.value() instanceof Expression.OfTerm value) {
      Expression.Fluent fluent = new Expression.Fluent(change.fluent().name(), List.of(self));
      firstValue(feature, value.term())
          .filter(first -> before.number(fluent).isEmpty())
          .ifPresent(first -> settings.put(fluent, first));
    } else if (effect instanceof Effect.Add add && isOfSelf(add.atom().arguments(), 2)) {
      vocabulary
          .predicate(add.atom().predicate())
          .filter(PredicateDeclaration::functional)
          .ifPresent(declared -> place(declared, self));
    }
  }

  private static boolean isOfSelf(List<Term> arguments, int size) {
    return arguments.size() == size && arguments.get(0).equals(Self.VARIABLE);
  }

  private static Optional<Double> firstValue(PricedFeature feature, Term value) {
    return feature.type().inputs().stream()
        .filter(input -> value.equals(new Term.Variable(input.name())))
        .map(Parameter::oneOf)
        .flatMap(values -> values.stream().limit(1))
        .filter(Term.Number.class::isInstance)
        .map(first -> ((Term.Number) first).value())
        .findFirst();
  }

  private void place(PredicateDeclaration declared, Term self) {
    Optional<Term> best = Optional.empty();
    double chance = -1;
    for (Term place : before.individuals(declared.parameters().get(1).className().orElse(""))) {
      if (place.equals(self)) {
        continue; // nothing is in itself
      }
      Formula.Atom atom = new Formula.Atom(declared.name(), List.of(self, place));
      Truth truth = before.truth(atom);
      if (truth == Truth.TRUE) {
        return;
      }
      if (truth == Truth.UNKNOWN && before.chanceStill(atom) > chance) {
        best = Optional.of(place);
        chance = before.chanceStill(atom);
      }
    }
    best.ifPresent(place -> places.put(new State(declared.name(), List.of(self)), place));
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    if (atom.arguments().size() == 2) {
      List<Term> subject = new ArrayList<>(atom.arguments().subList(0, 1));
      Term place = places.get(new State(atom.predicate(), subject));
      if (place != null) {
        return Truth.of(place.equals(atom.arguments().get(1)));
      }
    }
    return before.truth(atom);
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    Double setting = settings.get(fluent);
    return setting == null ? before.number(fluent) : OptionalDouble.of(setting);
  }

  @Override
  public double chanceStill(Formula.Atom atom) {
    return before.chanceStill(atom);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return before.individuals(className);
  }
}
