package org.maestro.sl;

import java.util.List;

/** A condition: of a goal, a precondition, a derived predicate or a question. */
public sealed interface Formula {

  /**
   * The formulas that it is made of, in order; none of an atom, a comparison, and what is unknown.
   */
  default List<Formula> parts() {
    return List.of();
  }

  /** A predicate applied to terms; a class name with one term is an atom too. */
  record Atom(String predicate, List<Term> arguments) implements Formula {
    public Atom {
      arguments = List.copyOf(arguments);
    }

    public boolean isGround() {
      return arguments.stream().allMatch(Term::isGround);
    }
  }

  record And(List<Formula> operands) implements Formula {
    public And {
      operands = List.copyOf(operands);
    }

    @Override
    public List<Formula> parts() {
      return operands;
    }
  }

  record Or(List<Formula> operands) implements Formula {
    public Or {
      operands = List.copyOf(operands);
    }

    @Override
    public List<Formula> parts() {
      return operands;
    }
  }

  record Not(Formula operand) implements Formula {
    @Override
    public List<Formula> parts() {
      return List.of(operand);
    }
  }

  record Imply(Formula premise, Formula conclusion) implements Formula {
    @Override
    public List<Formula> parts() {
      return List.of(premise, conclusion);
    }
  }

  record Exists(List<TypedVariable> variables, Formula body) implements Formula {
    public Exists {
      variables = List.copyOf(variables);
    }

    @Override
    public List<Formula> parts() {
      return List.of(body);
    }
  }

  record Forall(List<TypedVariable> variables, Formula body) implements Formula {
    public Forall {
      variables = List.copyOf(variables);
    }

    @Override
    public List<Formula> parts() {
      return List.of(body);
    }
  }

  /** A comparison of numbers, or the equality of two terms. */
  record Comparison(Relation relation, Expression left, Expression right) implements Formula {}

  /** The atom is neither known true nor excluded, or is too old. */
  record UnknownAtom(Atom atom) implements Formula {}

  /** The fluent has no known number, or one too old. */
  record UnknownNumber(Expression.Fluent fluent) implements Formula {}

  /** To hold until cancelled; legal as a goal only. */
  record Keep(Formula body) implements Formula {
    @Override
    public List<Formula> parts() {
      return List.of(body);
    }
  }

  /** A goal that begins or ends at a time or an event; legal as a goal only. */
  sealed interface Bound extends Formula {
    Occasion occasion();

    Formula goal();

    @Override
    default List<Formula> parts() {
      return occasion() instanceof Occasion.Event event
          ? List.of(event.condition(), goal())
          : List.of(goal());
    }
  }

  /** To be stated as a goal of its own then; at an event, for what the event binds. */
  record Upon(Occasion occasion, Formula goal) implements Bound {}

  /** A goal until then. */
  record Until(Occasion occasion, Formula goal) implements Bound {}

  /** The comparisons. */
  enum Relation {
    EQUAL("=", "exactly"),
    LESS("<", "less than"),
    AT_MOST("<=", "at most"),
    GREATER(">", "more than"),
    AT_LEAST(">=", "at least");

    private final String symbol;
    private final String words;

    Relation(String symbol, String words) {
      this.symbol = symbol;
      this.words = words;
    }

    public String inWords() {
      return words;
    }

    public String symbol() {
      return symbol;
    }
  }
}
