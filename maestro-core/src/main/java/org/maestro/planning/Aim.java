package org.maestro.planning;

/** That a variable gets a value. */
record Aim(Variable variable, int value) {

  /** Whether the change may bring it about. */
  boolean isReachedBy(Change change) {
    return change instanceof Change.OfVariable of
        && !(change instanceof Change.Remove)
        && of.variable() == variable
        && of.value() == value;
  }

  /** Whether it can be found by looking, without that something ends what is known first. */
  boolean isFindable() {
    return variable.isUnknown(variable.initialCode(), value);
  }
}
