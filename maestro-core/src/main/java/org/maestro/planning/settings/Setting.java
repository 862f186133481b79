package org.maestro.planning.settings;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeSet;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Quantity;
import org.maestro.sl.Effect.Assignment;

/**
 * A number that features only set to constants, and that is known: such as a dimmer's level.
 *
 * @param values all that it can have
 * @param distance the least cost to get from one value (first index) to another, over other values
 *     if that is cheaper
 */
public record Setting(NumberVariable variable, double[] values, double[][] distance) {

  /**
   * The setting that the variable is, if it is one.
   *
   * @param operators all that change the variable
   */
  static Optional<Setting> of(
      NumberVariable variable, List<Operator> operators, NumberVector initial) {
    if (Quantity.isUnknown(variable.initial())) {
      return Optional.empty();
    }
    TreeSet<Double> values = new TreeSet<>(List.of(variable.initial()));
    for (Operator operator : operators) {
      OptionalDouble set = constantSetBy(operator, variable);
      if (set.isEmpty()) {
        return Optional.empty();
      }
      values.add(set.getAsDouble());
    }
    double[] sorted = values.stream().mapToDouble(Double::doubleValue).toArray();
    return Optional.of(
        new Setting(variable, sorted, distances(variable, sorted, operators, initial)));
  }

  /**
   * The constant; empty when the operator does anything else to the variable, or its price reads
   * other variables.
   */
  private static OptionalDouble constantSetBy(Operator operator, NumberVariable variable) {
    OptionalDouble set = OptionalDouble.empty();
    for (Change change : operator.changes()) {
      if (change.target() == variable && !(change instanceof Change.Measure)) {
        if (!(change instanceof Change.Adjust adjust
                && adjust.condition() == Condition.Constant.TRUE
                && adjust.assignment() == Assignment.ASSIGN
                && adjust.value() instanceof NumberExpression.Constant constant
                && Double.isFinite(constant.number()))
            || set.isPresent()) {
          return OptionalDouble.empty();
        }
        set = OptionalDouble.of(Quantity.rounded(constant.number()));
      }
    }
    return readsOnly(operator.price().cost(), variable) ? set : OptionalDouble.empty();
  }

  static boolean readsNone(NumberExpression expression, NumberVariable variable) {
    boolean[] found = new boolean[1];
    expression.forEachVariable(read -> found[0] |= read == variable);
    return !found[0];
  }

  static boolean readsOnly(NumberExpression expression, NumberVariable variable) {
    boolean[] others = new boolean[1];
    expression.forEachVariable(read -> others[0] |= read != variable);
    return !others[0];
  }

  private static double[][] distances(
      NumberVariable variable, double[] values, List<Operator> operators, NumberVector initial) {
    int n = values.length;
    double[][] distance = new double[n][n];
    for (int from = 0; from < n; from++) {
      Arrays.fill(distance[from], Double.POSITIVE_INFINITY);
      distance[from][from] = 0;
      NumberVector numbers = initial.with(variable.index(), values[from]);
      for (Operator operator : operators) {
        int to = Arrays.binarySearch(values, constantSetBy(operator, variable).orElseThrow());
        double cost = operator.price().cost(numbers);
        if (cost < distance[from][to]) {
          distance[from][to] = cost;
        }
      }
    }
    for (int via = 0; via < n; via++) {
      for (int from = 0; from < n; from++) {
        for (int to = 0; to < n; to++) {
          distance[from][to] =
              Math.min(distance[from][to], distance[from][via] + distance[via][to]);
        }
      }
    }
    return distance;
  }

  public int indexOf(double value) {
    return Arrays.binarySearch(values, value);
  }
}
