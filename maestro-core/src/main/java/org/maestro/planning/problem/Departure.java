package org.maestro.planning.problem;

/** The end of a value that a variable has. */
public record Departure(Variable variable, int value) {

  /** Whether the operator may bring it about: it is of no use to one that needs another value. */
  public boolean isBroughtAboutBy(Operator operator) {
    for (Change change : operator.changes()) {
      if (isBroughtAboutBy(change)) {
        return !asksForAnother(operator);
      }
    }
    return false;
  }

  private boolean isBroughtAboutBy(Change change) {
    return change instanceof Change.Put put && put.variable() == variable && put.value() != value
        || change instanceof Change.Remove remove
            && remove.variable() == variable
            && remove.value() == value;
  }

  private boolean asksForAnother(Operator operator) {
    for (Condition part : operator.precondition().conjuncts()) {
      if (part instanceof Condition.Literal literal
          && literal.variable() == variable
          && literal.question() == Condition.Question.IS
          && literal.value() != value
          && variable.functional()) {
        return true;
      }
    }
    return false;
  }
}
