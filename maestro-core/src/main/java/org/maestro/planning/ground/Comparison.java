package org.maestro.planning.ground;

/** Two amounts and one of {@code < <= = >= >}. */
public record Comparison(Relation relation, Amount left, Amount right) {
  /** The relation in which the left amount has to stand to the right one. */
  public enum Relation {
    LESS,
    AT_MOST,
    EQUAL,
    AT_LEAST,
    MORE
  }
}
