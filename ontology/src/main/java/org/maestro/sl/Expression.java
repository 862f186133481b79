package org.maestro.sl;

import java.util.List;

/** A number, a fluent's value, arithmetic over both, or (in an equality) any term. */
public sealed interface Expression {

  record OfTerm(Term term) implements Expression {}

  /** The value of a numeric fluent, {@code (illuminance ?zone)}. */
  record Fluent(String name, List<Term> arguments) implements Expression {
    public Fluent {
      arguments = List.copyOf(arguments);
    }
  }

  record Arithmetic(Operator operator, List<Expression> operands) implements Expression {
    public Arithmetic {
      operands = List.copyOf(operands);
    }
  }

  /** The arithmetic operators; minus with one operand negates. */
  enum Operator {
    PLUS("+"),
    MINUS("-"),
    TIMES("*"),
    DIVIDE("/"),
    MIN("min"),
    MAX("max");

    private final String symbol;

    Operator(String symbol) {
      this.symbol = symbol;
    }

    public String symbol() {
      return symbol;
    }

    /** The result for one or more operands; not finite after a division by zero. */
    public double apply(double... operands) {
      double result = operands[0];
      if (operands.length == 1 && this == MINUS) {
        return -result;
      }
      for (int i = 1; i < operands.length; i++) {
        result =
            switch (this) {
              case PLUS -> result + operands[i];
              case MINUS -> result - operands[i];
              case TIMES -> result * operands[i];
              case DIVIDE -> result / operands[i];
              case MIN -> Math.min(result, operands[i]);
              case MAX -> Math.max(result, operands[i]);
            };
      }
      return result;
    }
  }
}
