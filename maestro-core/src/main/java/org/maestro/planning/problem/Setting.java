package org.maestro.planning.problem;

import java.util.Arrays;
import java.util.List;
import java.util.TreeSet;
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
   * The setting that the variable is, or null when it is none.
   *
   * @param operators all that change the variable
   */
  static Setting of(NumberVariable variable, List<Operator> operators, NumberVector initial) {
    if (Quantity.isUnknown(variable.initial())) {
      return null;
    }
    TreeSet<Double> values = new TreeSet<>(List.of(variable.initial()));
    for (Operator operator : operators) {
      Double set = constantSetBy(operator, variable);
      if (set == null) {
        return null;
      }
      values.add(set);
    }
    double[] sorted = values.stream().mapToDouble(Double::doubleValue).toArray();
    return new Setting(variable, sorted, distances(variable, sorted, operators, initial));
  }

  /**
   * The constant, or null when the operator does anything else to the variable, or its price reads
   * other variables.
   */
  private static Double constantSetBy(Operator operator, NumberVariable variable) {
    Double set = null;
    for (Change change : operator.changes()) {
      if (change.target() == variable && !(change instanceof Change.Measure)) {
        if (!(change instanceof Change.Adjust adjust
                && adjust.condition() == Condition.Constant.TRUE
                && adjust.assignment() == Assignment.ASSIGN
                && adjust.value() instanceof NumberExpression.Constant constant
                && Double.isFinite(constant.number()))
            || set != null) {
          return null;
        }
        set = Quantity.rounded(constant.number());
      }
    }
    return readsOnly(operator.price().cost(), variable) ? set : null;
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
        int to = Arrays.binarySearch(values, constantSetBy(operator, variable));
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
