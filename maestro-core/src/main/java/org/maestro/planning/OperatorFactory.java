package org.maestro.planning;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.Condition.Constant;
import org.maestro.planning.Condition.Question;
import org.maestro.planning.PricedFeature.ExactPrice;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * Makes ground operators of features and bindings, with their prices.
 *
 * <p>Looking for a thing elsewhere than where it is expected first ({@code likelyWhen}) costs
 * {@link #UNLIKELY_PLACE_SURCHARGE}, as long as one of the expected places is not excluded. Such a
 * feature instance becomes two operators: one for where the place of the thing is unknown, with the
 * surcharge, and one for where it is known.
 */
final class OperatorFactory {
  /** In cost units: about what a search that fails costs. */
  static final double UNLIKELY_PLACE_SURCHARGE = 5;

  private final Signature signature;
  private final StaticFacts facts;
  private final Variables variables;
  private final ConditionCompiler conditions;
  private final ConditionCompiler preconditions;
  private final EffectCompiler effects;

  OperatorFactory(
      Signature signature,
      StaticFacts facts,
      Variables variables,
      ConditionCompiler conditions,
      ConditionCompiler preconditions) {
    this.signature = signature;
    this.facts = facts;
    this.variables = variables;
    this.conditions = conditions;
    this.preconditions = preconditions;
    this.effects = new EffectCompiler(conditions, variables);
  }

  /**
   * The operators of a feature instance: none when it can never be done, two when a surcharge
   * depends on what is known.
   */
  List<Operator> operators(PricedFeature feature, Map<String, Term> parameters) {
    Map<String, Term> bindings = new HashMap<>(parameters);
    bindings.put("self", new Term.Name(feature.member()));
    Condition precondition = preconditions.condition(feature.type().precondition(), bindings);
    if (precondition == Constant.FALSE) {
      return List.of();
    }
    StepPrice price = price(feature, parameters, bindings);
    if (price.cost() instanceof NumberExpression.Constant constant
        && !(Double.isFinite(constant.number()) && constant.number() >= 0)) {
      return List.of();
    }
    List<Change> changes = effects.changes(feature.type().effect(), bindings);
    return surcharged(new Operator(feature, parameters, precondition, changes, price));
  }

  private StepPrice price(
      PricedFeature feature, Map<String, Term> parameters, Map<String, Term> bindings) {
    ExactPrice exact = feature.exact().get(parameters);
    if (exact != null) {
      return new StepPrice(
          new NumberExpression.Constant(exact.cost()),
          new NumberExpression.Constant(exact.seconds()),
          0,
          true);
    }
    return new StepPrice(
        conditions.number(FeatureTemplate.statedPrice(feature), bindings),
        conditions.number(feature.type().seconds(), bindings),
        0,
        feature.price() instanceof Price.Stated);
  }

  private List<Operator> surcharged(Operator operator) {
    List<Condition> unknown = new ArrayList<>();
    List<Condition> known = new ArrayList<>();
    for (Change change : operator.changes()) {
      if (change instanceof Change.Find find && isUnlikely(find.variable(), find.value())) {
        unknown.add(new Condition.Literal(find.variable(), find.value(), Question.UNKNOWN));
        known.add(new Condition.Literal(find.variable(), find.value(), Question.NOT_UNKNOWN));
      }
    }
    if (unknown.isEmpty()) {
      return List.of(operator);
    }
    Condition before = operator.precondition();
    return List.of(
        operator
            .withPrecondition(Condition.all(List.of(before, Condition.any(unknown))))
            .withPrice(operator.price().withSurcharge(UNLIKELY_PLACE_SURCHARGE)),
        operator.withPrecondition(Condition.all(List.of(before, Condition.all(known)))));
  }

  /** Whether other values are expected first, and one of them is still possible. */
  private boolean isUnlikely(Variable variable, int value) {
    Optional<PredicateDeclaration> declaration = signature.declaration(variable.predicate());
    Optional<Formula> likely = declaration.flatMap(PredicateDeclaration::likelyWhen);
    if (likely.isEmpty() || !variable.functional() || variable.initialCode() >= 0) {
      return false;
    }
    List<TypedVariable> parameters = declaration.get().parameters();
    Map<String, Term> bindings = new HashMap<>();
    for (int i = 0; i < variable.arguments().size(); i++) {
      bindings.put(parameters.get(i).name(), variable.arguments().get(i));
    }
    TypedVariable last = parameters.get(parameters.size() - 1);
    boolean elsewhere = false;
    for (Term place : facts.individuals(last.className().orElse(""))) {
      bindings.put(last.name(), place);
      if (conditions.condition(likely.get(), bindings) == Constant.TRUE) {
        int expected = variable.indexOf(place);
        if (expected == value) {
          return false;
        }
        elsewhere |= variable.isUnknown(variable.initialCode(), expected);
      }
    }
    return elsewhere;
  }
}
