package org.maestro.planning.problem;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.PricedFeature;
import org.maestro.sl.Expression;
import org.maestro.sl.Self;
import org.maestro.sl.Term;

/**
 * A lower bound on a feature's price, whatever its parameters are and whatever happens: interval
 * arithmetic over its price, with the whole line for what may change.
 */
public final class LeastPrice {
  private record Range(double low, double high) {
    private static final Range ALL = new Range(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);

    static Range of(double value) {
      return new Range(value, value);
    }

    Range over(Expression.Operator operator, Range other) {
      double least = Double.POSITIVE_INFINITY;
      double most = Double.NEGATIVE_INFINITY;
      for (double left : new double[] {low, high}) {
        for (double right : new double[] {other.low, other.high}) {
          double value = operator.apply(left, right);
          if (Double.isNaN(value)) {
            // Zero times what may be anything.
            value = 0;
          }
          least = Math.min(least, value);
          most = Math.max(most, value);
        }
      }
      return new Range(least, most);
    }
  }

  private final StaticFacts facts;
  private final Signature signature;

  /**
   * @param signature says what may change, and so may have any value
   */
  public LeastPrice(StaticFacts facts, Signature signature) {
    this.facts = facts;
    this.signature = signature;
  }

  /** From 0, in cost units. */
  public double of(PricedFeature feature) {
    Expression price =
        feature.price() instanceof Price.Stated stated
            ? stated.cost()
            : ((Price.Asked) feature.price()).atLeast();
    double least = range(price, feature).low();
    for (PricedFeature.ExactPrice exact : feature.exact().values()) {
      least = Math.min(least, exact.cost());
    }
    return Double.isFinite(least) ? Math.max(0, least) : 0;
  }

  private Range range(Expression expression, PricedFeature feature) {
    if (expression instanceof Expression.OfTerm of) {
      return range(of.term(), feature);
    } else if (expression instanceof Expression.Fluent fluent) {
      return known(fluent, feature.member());
    }
    Expression.Arithmetic arithmetic = (Expression.Arithmetic) expression;
    List<Range> operands = arithmetic.operands().stream().map(o -> range(o, feature)).toList();
    if (operands.size() == 1) {
      return arithmetic.operator() == Expression.Operator.MINUS
          ? new Range(-operands.get(0).high(), -operands.get(0).low())
          : operands.get(0);
    }
    Range result = operands.get(0);
    for (Range operand : operands.subList(1, operands.size())) {
      boolean divisorMayVanish =
          arithmetic.operator() == Expression.Operator.DIVIDE
              && operand.low() <= 0
              && operand.high() >= 0;
      result = divisorMayVanish ? Range.ALL : result.over(arithmetic.operator(), operand);
    }
    return result;
  }

  private static Range range(Term term, PricedFeature feature) {
    if (term instanceof Term.Number number) {
      return Range.of(number.value());
    } else if (term instanceof Term.Variable variable) {
      Optional<Parameter> parameter =
          feature.type().inputs().stream()
              .filter(input -> input.name().equals(variable.name()))
              .findFirst();
      List<Term> choices = parameter.map(Parameter::oneOf).orElse(List.of());
      if (!choices.isEmpty() && choices.stream().allMatch(Term.Number.class::isInstance)) {
        return new Range(
            choices.stream().mapToDouble(c -> ((Term.Number) c).value()).min().getAsDouble(),
            choices.stream().mapToDouble(c -> ((Term.Number) c).value()).max().getAsDouble());
      }
    }
    return Range.ALL;
  }

  private Range known(Expression.Fluent fluent, String member) {
    Map<String, Term> self = Self.is(member);
    List<Term> arguments =
        fluent.arguments().stream()
            .map(
                argument ->
                    argument instanceof Term.Variable variable
                        ? self.getOrDefault(variable.name(), argument)
                        : argument)
            .toList();
    if (signature.isDynamic(fluent.name()) || !arguments.stream().allMatch(Term::isGround)) {
      return Range.ALL;
    }
    double value = facts.number(new Expression.Fluent(fluent.name(), arguments));
    return Quantity.isUnknown(value) ? Range.ALL : Range.of(value);
  }
}
