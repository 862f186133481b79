package org.maestro.planning.ground;

/** An atom that has to hold, or that must not. */
public record Literal(Atom atom, boolean positive) {
  // Written out, as grounding begins with it: the one that Java links at run time takes longer the
  // first time than a cancelled planner may.
  @Override
  public boolean equals(Object other) {
    return other instanceof Literal that && positive == that.positive && atom.equals(that.atom);
  }

  @Override
  public int hashCode() {
    return 31 * atom.hashCode() + Boolean.hashCode(positive);
  }
}
