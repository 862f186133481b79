package org.maestro.planning.problem;

/** The assignment of a value to a variable. */
public record VariableValue(Variable variable, int value) {

  /** Whether the change may bring it about. */
  public boolean isReachedBy(Change change) {
    return change instanceof Change.OfVariable of
        && !(change instanceof Change.Remove)
        && of.variable() == variable
        && of.value() == value;
  }

  /** Whether it can be found by looking, without that something ends what is known first. */
  public boolean isFindable() {
    return variable.isUnknown(variable.initialCode(), value);
  }

  /**
   * Spelled out because aims are looked up more than anything else while a problem is made ground:
   * what a record has of itself is many times slower until it is compiled.
   */
  @Override
  public boolean equals(Object other) {
    return other instanceof VariableValue aim && aim.variable == variable && aim.value == value;
  }

  @Override
  public int hashCode() {
    return 31 * variable.hashCode() + value;
  }
}
