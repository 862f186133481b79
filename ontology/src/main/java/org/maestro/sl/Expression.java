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
  }
}
