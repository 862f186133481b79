package org.maestro.planning.ground;

import java.math.BigDecimal;

/** A number in a task with parameters: of constants and functions. */
public sealed interface Amount {
  record Constant(BigDecimal value) implements Amount {}

  /** A function's value. */
  record Value(Atom function) implements Amount {}

  /** Two amounts and one of {@code + - * /}. */
  record Operation(char operator, Amount left, Amount right) implements Amount {}
}
