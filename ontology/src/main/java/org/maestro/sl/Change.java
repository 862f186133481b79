package org.maestro.sl;

import java.util.OptionalDouble;

/** A ground change that an effect makes to what is known. */
public sealed interface Change {

  /** The atom holds, or is known not to hold. */
  record OfTruth(Formula.Atom atom, boolean value) implements Change {}

  /**
   * The number's new value; empty when it followed from an unknown one, and so is unknown itself.
   */
  record OfNumber(Expression.Fluent fluent, OptionalDouble value) implements Change {}
}
