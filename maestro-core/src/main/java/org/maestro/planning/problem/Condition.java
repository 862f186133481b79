package org.maestro.planning.problem;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.sl.Formula.Relation;

/**
 * A ground condition over the planning state, without negations inside. An atom holds only if known
 * true, a comparison with an unknown number fails, and with "any" holds, negated or not.
 */
public sealed interface Condition {

  boolean holds(State state);

  /** Visits the parts that are neither conjunction, disjunction nor constant. */
  default void forEachLeaf(Consumer<Condition> visitor) {
    visitor.accept(this);
  }

  /** The parts all of which must hold. */
  default List<Condition> conjuncts() {
    return List.of(this);
  }

  enum Constant implements Condition {
    TRUE,
    FALSE;

    public static Constant of(boolean value) {
      return value ? TRUE : FALSE;
    }

    @Override
    public boolean holds(State state) {
      return this == TRUE;
    }

    @Override
    public void forEachLeaf(Consumer<Condition> visitor) {
      // a constant depends on nothing
    }

    @Override
    public List<Condition> conjuncts() {
      return this == TRUE ? List.of() : List.of(this);
    }
  }

  /** A question about a variable and one of its values. */
  enum Question {
    IS,
    IS_NOT,
    UNKNOWN,
    NOT_UNKNOWN
  }

  record Literal(Variable variable, int value, Question question) implements Condition {
    @Override
    public boolean holds(State state) {
      return holdsFor(state.code(variable));
    }

    public boolean holdsFor(int code) {
      return switch (question) {
        case IS -> code == value;
        case IS_NOT -> code != value;
        case UNKNOWN -> variable.isUnknown(code, value);
        case NOT_UNKNOWN -> !variable.isUnknown(code, value);
      };
    }

    /** Spelled out for the reason for which those of {@link VariableValue} are. */
    @Override
    public boolean equals(Object other) {
      return other instanceof Literal literal
          && literal.variable == variable
          && literal.value == value
          && literal.question == question;
    }

    @Override
    @SuppressWarnings("EnumOrdinal") // Other than the question's own hash, the same in every run.
    public int hashCode() {
      return 31 * (31 * variable.hashCode() + value) + question.ordinal();
    }
  }

  record NumberKnown(NumberVariable variable, boolean known) implements Condition {
    @Override
    public boolean holds(State state) {
      return Quantity.isUnknown(state.number(variable)) != known;
    }
  }

  /**
   * A permanent obstacle, kept for explanations only: a static condition that does not hold, a
   * member that is not there, a step that is not done.
   */
  record Fixed(Obstacle obstacle) implements Condition {
    @Override
    public boolean holds(State state) {
      return false;
    }
  }

  record Compare(Relation relation, NumberExpression left, NumberExpression right, boolean positive)
      implements Condition {
    @Override
    public boolean holds(State state) {
      return holdsFor(left.value(state.numbers()), right.value(state.numbers()));
    }

    public boolean holdsFor(double a, double b) {
      if (Quantity.isUnknown(a) || Quantity.isUnknown(b)) {
        return !positive;
      }
      return Quantity.isAny(a) || Quantity.isAny(b) || compares(a, b) == positive;
    }

    private boolean compares(double a, double b) {
      return switch (relation) {
        case EQUAL -> Quantity.atLeast(a, b) && Quantity.atLeast(b, a);
        case LESS -> Quantity.greater(b, a);
        case AT_MOST -> Quantity.atLeast(b, a);
        case GREATER -> Quantity.greater(a, b);
        case AT_LEAST -> Quantity.atLeast(a, b);
      };
    }
  }

  record All(List<Condition> parts) implements Condition {
    @Override
    public boolean holds(State state) {
      for (int i = 0; i < parts.size(); i++) {
        if (!parts.get(i).holds(state)) {
          return false;
        }
      }
      return true;
    }

    @Override
    public void forEachLeaf(Consumer<Condition> visitor) {
      parts.forEach(part -> part.forEachLeaf(visitor));
    }

    @Override
    public List<Condition> conjuncts() {
      return parts;
    }
  }

  record Any(List<Condition> parts) implements Condition {
    @Override
    public boolean holds(State state) {
      for (int i = 0; i < parts.size(); i++) {
        if (parts.get(i).holds(state)) {
          return true;
        }
      }
      return false;
    }

    @Override
    public void forEachLeaf(Consumer<Condition> visitor) {
      parts.forEach(part -> part.forEachLeaf(visitor));
    }
  }

  static Condition all(List<Condition> parts) {
    Set<Condition> flat = new LinkedHashSet<>();
    for (Condition part : parts) {
      if (part == Constant.FALSE) {
        return Constant.FALSE;
      }
      flat.addAll(part.conjuncts());
    }
    return switch (flat.size()) {
      case 0 -> Constant.TRUE;
      case 1 -> flat.iterator().next();
      default -> new All(List.copyOf(flat));
    };
  }

  static Condition any(List<Condition> parts) {
    Set<Condition> flat = new LinkedHashSet<>();
    for (Condition part : parts) {
      if (part == Constant.TRUE) {
        return Constant.TRUE;
      }
      List<Condition> alternatives =
          part instanceof Any any
              ? any.parts()
              : part == Constant.FALSE ? List.of() : List.of(part);
      flat.addAll(alternatives);
    }
    return switch (flat.size()) {
      case 0 -> Constant.FALSE;
      case 1 -> flat.iterator().next();
      default -> new Any(List.copyOf(flat));
    };
  }
}
