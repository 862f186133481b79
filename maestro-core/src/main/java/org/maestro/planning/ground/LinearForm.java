package org.maestro.planning.ground;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;

/** A constant and multiples of functions that change. */
record LinearForm(Map<Atom, BigDecimal> factors, BigDecimal constant) {
  private static final Comparator<Atom> ORDER =
      Comparator.comparingInt(Atom::symbol)
          .thenComparing(Atom::terms, (a, b) -> Arrays.compare(a, b));

  /**
   * What an amount is for a binding; empty when a function in it has no value.
   *
   * @throws GroundingException when the amount is not linear
   */
  static Optional<LinearForm> of(
      Amount amount, int[] binding, Map<Atom, BigDecimal> values, Predicate<Atom> changes) {
    if (amount instanceof Amount.Constant constant) {
      return Optional.of(new LinearForm(Map.of(), constant.value()));
    }
    if (amount instanceof Amount.Value value) {
      Atom function = new Atom(value.function().symbol(), value.function().ground(binding));
      BigDecimal now = values.get(function);
      if (now == null) {
        return Optional.empty();
      }
      if (!changes.test(function)) {
        return Optional.of(new LinearForm(Map.of(), now));
      }
      TreeMap<Atom, BigDecimal> one = new TreeMap<>(ORDER);
      one.put(function, BigDecimal.ONE);
      return Optional.of(new LinearForm(one, BigDecimal.ZERO));
    }
    Amount.Operation operation = (Amount.Operation) amount;
    Optional<LinearForm> left = of(operation.left(), binding, values, changes);
    Optional<LinearForm> right = of(operation.right(), binding, values, changes);
    if (left.isEmpty() || right.isEmpty()) {
      return Optional.empty();
    }
    return combine(operation.operator(), left.get(), right.get());
  }

  private static Optional<LinearForm> combine(char operator, LinearForm left, LinearForm right) {
    switch (operator) {
      case '+':
        return Optional.of(left.plus(right, BigDecimal.ONE));
      case '-':
        return Optional.of(left.plus(right, BigDecimal.ONE.negate()));
      case '*':
        if (left.isConstant()) {
          return Optional.of(right.times(left.constant()));
        }
        if (right.isConstant()) {
          return Optional.of(left.times(right.constant()));
        }
        throw new GroundingException("A product of two numbers that change is not supported.");
      default:
        if (!right.isConstant()) {
          throw new GroundingException("Division by a number that changes is not supported.");
        }
        return right.constant().signum() == 0
            ? Optional.empty()
            : Optional.of(
                left.times(BigDecimal.ONE.divide(right.constant(), MathContext.DECIMAL64)));
    }
  }

  boolean isConstant() {
    return factors.isEmpty();
  }

  LinearForm minus(LinearForm other) {
    return plus(other, BigDecimal.ONE.negate());
  }

  private LinearForm plus(LinearForm other, BigDecimal factor) {
    TreeMap<Atom, BigDecimal> sum = new TreeMap<>(ORDER);
    sum.putAll(factors);
    other.factors.forEach(
        (function, share) -> sum.merge(function, share.multiply(factor), BigDecimal::add));
    sum.values().removeIf(share -> share.signum() == 0);
    return new LinearForm(sum, constant.add(other.constant.multiply(factor)));
  }

  LinearForm times(BigDecimal factor) {
    TreeMap<Atom, BigDecimal> product = new TreeMap<>(ORDER);
    if (factor.signum() != 0) {
      factors.forEach((function, share) -> product.put(function, share.multiply(factor)));
    }
    return new LinearForm(product, constant.multiply(factor));
  }
}
