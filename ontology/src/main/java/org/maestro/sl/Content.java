package org.maestro.sl;

import java.util.List;

/** One content element of a message: an operator with arguments, {@code (initCNP (:goal ...))}. */
public record Content(String operator, List<Argument> arguments) {
  public Content {
    arguments = List.copyOf(arguments);
  }

  /**
   * An argument of a content element. What is both formula and term by its looks is read as the
   * term.
   */
  public sealed interface Argument {

    record OfFormula(Formula formula) implements Argument {}

    record OfTerm(Term term) implements Argument {}

    /** An effect that is not a formula, such as {@code (assign (level lamp-b1) 1)}. */
    record OfEffect(Effect effect) implements Argument {}

    record Nested(Content content) implements Argument {}

    /** {@code (:name argument*)}, or {@code :name argument}. */
    record Named(String name, List<Argument> arguments) implements Argument {
      public Named {
        arguments = List.copyOf(arguments);
      }
    }
  }
}
