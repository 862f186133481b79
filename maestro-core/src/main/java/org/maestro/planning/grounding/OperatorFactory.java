package org.maestro.planning.grounding;

import java.util.List;
import java.util.Map;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.PricedFeature.ExactPrice;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.Condition.Constant;
import org.maestro.planning.problem.ConditionCompiler;
import org.maestro.planning.problem.EffectCompiler;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.StepPrice;
import org.maestro.sl.Self;
import org.maestro.sl.Term;

/** Makes ground operators of features and bindings, with their prices. */
final class OperatorFactory {
  private final ConditionCompiler conditions;
  private final ConditionCompiler preconditions;
  private final EffectCompiler effects;

  OperatorFactory(
      ConditionCompiler conditions, ConditionCompiler preconditions, EffectCompiler effects) {
    this.conditions = conditions;
    this.preconditions = preconditions;
    this.effects = effects;
  }

  /** The operator of a feature instance; none when it can never be done. */
  List<Operator> operators(PricedFeature feature, Map<String, Term> parameters) {
    Map<String, Term> bindings = withSelf(feature, parameters);
    Condition precondition = preconditions.condition(feature.type().precondition(), bindings);
    if (precondition == Constant.FALSE) {
      return List.of();
    }
    StepPrice price = price(feature, parameters, bindings);
    if (!isPossible(price)) {
      return List.of();
    }
    List<Change> changes = effects.changes(feature.type().effect(), bindings);
    return List.of(new Operator(feature, parameters, precondition, changes, price));
  }

  private static boolean isPossible(StepPrice price) {
    return !(price.cost() instanceof NumberExpression.Constant constant)
        || Double.isFinite(constant.number()) && constant.number() >= 0;
  }

  /** The same step of a feature that differs in prices which the member itself has given. */
  List<Operator> repriced(Operator operator, PricedFeature feature) {
    StepPrice price = price(feature, operator.bindings(), withSelf(feature, operator.bindings()));
    return isPossible(price) ? List.of(operator.offered(feature, price)) : List.of();
  }

  /** What an instance costs, whether it can be done or not; how long it takes is not asked for. */
  NumberExpression cost(PricedFeature feature, Map<String, Term> parameters) {
    ExactPrice exact = feature.exact().get(parameters);
    return exact == null
        ? conditions.number(FeatureTemplate.statedPrice(feature), withSelf(feature, parameters))
        : new NumberExpression.Constant(exact.cost());
  }

  private static Map<String, Term> withSelf(PricedFeature feature, Map<String, Term> parameters) {
    return Self.is(feature.member(), parameters);
  }

  private StepPrice price(
      PricedFeature feature, Map<String, Term> parameters, Map<String, Term> bindings) {
    ExactPrice exact = feature.exact().get(parameters);
    if (exact != null) {
      return new StepPrice(
          new NumberExpression.Constant(exact.cost()),
          new NumberExpression.Constant(exact.seconds()),
          true);
    }
    return new StepPrice(
        conditions.number(FeatureTemplate.statedPrice(feature), bindings),
        conditions.number(feature.type().seconds(), bindings),
        feature.price() instanceof Price.Stated);
  }
}
