package org.maestro.planning.problem;

import java.util.List;
import java.util.function.Consumer;
import org.maestro.sl.Expression.Operator;

/** A ground numeric expression over the numbers of a state. */
public sealed interface NumberExpression {

  /**
   * A number, {@link Quantity#UNKNOWN} when a part is unknown, {@link Quantity#ANY} when a part is
   * "any".
   */
  double value(NumberVector numbers);

  void forEachVariable(Consumer<NumberVariable> visitor);

  default boolean isConstant() {
    return this instanceof Constant;
  }

  record Constant(double number) implements NumberExpression {
    @Override
    public double value(NumberVector numbers) {
      return number;
    }

    @Override
    public void forEachVariable(Consumer<NumberVariable> visitor) {
      // a constant reads no variable
    }
  }

  record Read(NumberVariable variable) implements NumberExpression {
    @Override
    public double value(NumberVector numbers) {
      return numbers.get(variable.index());
    }

    @Override
    public void forEachVariable(Consumer<NumberVariable> visitor) {
      visitor.accept(variable);
    }
  }

  record Operation(Operator operator, List<NumberExpression> operands) implements NumberExpression {
    @Override
    public double value(NumberVector numbers) {
      boolean any = false;
      double result = 0;
      for (int i = 0; i < operands.size(); i++) {
        double operand = operands.get(i).value(numbers);
        if (Quantity.isUnknown(operand)) {
          return Quantity.UNKNOWN;
        }
        any |= Quantity.isAny(operand);
        result = i == 0 ? operand : combined(result, operand);
      }
      if (any) {
        return Quantity.ANY;
      }
      double signed = operator == Operator.MINUS && operands.size() == 1 ? -result : result;
      return Double.isFinite(signed) ? signed : Quantity.UNKNOWN;
    }

    private double combined(double left, double right) {
      return switch (operator) {
        case PLUS -> left + right;
        case MINUS -> left - right;
        case TIMES -> left * right;
        case DIVIDE -> left / right;
        case MIN -> Math.min(left, right);
        case MAX -> Math.max(left, right);
      };
    }

    @Override
    public void forEachVariable(Consumer<NumberVariable> visitor) {
      operands.forEach(operand -> operand.forEachVariable(visitor));
    }
  }
}
