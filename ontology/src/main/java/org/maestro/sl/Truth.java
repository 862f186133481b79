package org.maestro.sl;

/** Three-valued truth: what was neither seen nor excluded is unknown. */
public enum Truth {
  TRUE,
  FALSE,
  UNKNOWN;

  public static Truth of(boolean value) {
    return value ? TRUE : FALSE;
  }
}
