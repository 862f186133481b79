package org.maestro.sl;

import java.math.BigDecimal;
import java.util.List;
import java.util.function.BiConsumer;

/**
 * Prints trees as MAESTRO-SL; the inverse of {@link SlParser}. Numbers are written shortest: {@code
 * 17}, {@code 0.25}.
 */
public final class SlPrinter {

  private static final double LARGEST_PLAIN = 1e15;
  private static final double SMALLEST_PLAIN = 1e-6;

  private final StringBuilder out = new StringBuilder();

  private SlPrinter() {}

  public static String print(Term term) {
    return printed(SlPrinter::write, term);
  }

  /** A finite number without needless digits. */
  public static String print(double value) {
    if (value == Math.rint(value) && Math.abs(value) < LARGEST_PLAIN) {
      return value == 0 && 1 / value < 0 ? "-0" : String.valueOf((long) value);
    }
    return Math.abs(value) < LARGEST_PLAIN && Math.abs(value) >= SMALLEST_PLAIN
        ? new BigDecimal(Double.toString(value)).stripTrailingZeros().toPlainString()
        : Double.toString(value);
  }

  public static String print(TypedVariable variable) {
    return printed(SlPrinter::write, variable);
  }

  public static String print(Expression expression) {
    return printed(SlPrinter::write, expression);
  }

  public static String print(Formula formula) {
    return printed(SlPrinter::write, formula);
  }

  public static String print(Effect effect) {
    return printed(SlPrinter::write, effect);
  }

  public static String print(Body body) {
    return BodyPrinter.print(body);
  }

  /** The same without the steps that are in it. */
  public static String head(Body body) {
    return BodyPrinter.head(body);
  }

  public static String print(Fact fact) {
    return printed(SlPrinter::write, fact);
  }

  public static String print(Content content) {
    return printed(SlPrinter::write, content);
  }

  /** Several elements, a blank between them. */
  public static String print(List<Content> contents) {
    return printed((printer, all) -> printer.list(all, SlPrinter::write), contents);
  }

  public static String print(Content.Argument argument) {
    return printed(SlPrinter::write, argument);
  }

  private static <T> String printed(BiConsumer<SlPrinter, T> writer, T part) {
    SlPrinter printer = new SlPrinter();
    writer.accept(printer, part);
    return printer.out.toString();
  }

  private void write(Term term) {
    if (term instanceof Term.Variable variable) {
      out.append('?').append(variable.name());
    } else if (term instanceof Term.Name name) {
      out.append(name.text());
    } else if (term instanceof Term.Iri iri) {
      out.append('<').append(iri.text()).append('>');
    } else if (term instanceof Term.Number number) {
      out.append(print(number.value()));
    } else if (term instanceof Term.Text text) {
      quoted(text.value());
    } else {
      out.append(((Term.Truth) term).value());
    }
  }

  private void quoted(String text) {
    out.append('"');
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == '\\' || c == '"') {
        out.append('\\');
      }
      out.append(c);
    }
    out.append('"');
  }

  private void write(TypedVariable variable) {
    out.append('?').append(variable.name());
    variable.className().ifPresent(name -> out.append(" - ").append(name));
  }

  private void write(Expression expression) {
    if (expression instanceof Expression.OfTerm ofTerm) {
      write(ofTerm.term());
    } else if (expression instanceof Expression.Fluent fluent) {
      group(fluent.name(), fluent.arguments(), SlPrinter::write);
    } else {
      Expression.Arithmetic arithmetic = (Expression.Arithmetic) expression;
      group(arithmetic.operator().symbol(), arithmetic.operands(), SlPrinter::write);
    }
  }

  private void write(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      group(atom.predicate(), atom.arguments(), SlPrinter::write);
    } else if (formula instanceof Formula.And and) {
      group("and", and.operands(), SlPrinter::write);
    } else if (formula instanceof Formula.Or or) {
      group("or", or.operands(), SlPrinter::write);
    } else if (formula instanceof Formula.Not not) {
      group("not", List.of(not.operand()), SlPrinter::write);
    } else if (formula instanceof Formula.Imply imply) {
      group("imply", List.of(imply.premise(), imply.conclusion()), SlPrinter::write);
    } else if (formula instanceof Formula.Exists exists) {
      quantified("exists", exists.variables());
      end(exists.body());
    } else if (formula instanceof Formula.Forall forall) {
      quantified("forall", forall.variables());
      end(forall.body());
    } else if (formula instanceof Formula.Comparison comparison) {
      List<Expression> sides = List.of(comparison.left(), comparison.right());
      group(comparison.relation().symbol(), sides, SlPrinter::write);
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      group("unknown", List.of(unknown.atom()), SlPrinter::write);
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      group("unknown", List.of(unknown.fluent()), SlPrinter::write);
    } else if (formula instanceof Formula.Bound bound) {
      out.append(OccasionSyntax.begin(bound));
      end(bound.goal());
    } else {
      group("keep", List.of(((Formula.Keep) formula).body()), SlPrinter::write);
    }
  }

  private void write(Effect effect) {
    if (effect instanceof Effect.Add add) {
      write(add.atom());
    } else if (effect instanceof Effect.Delete delete) {
      group("not", List.of(delete.atom()), SlPrinter::write);
    } else if (effect instanceof Effect.All all) {
      group("and", all.effects(), SlPrinter::write);
    } else if (effect instanceof Effect.When when) {
      out.append("(when ");
      write(when.condition());
      end(when.effect());
    } else if (effect instanceof Effect.Forall forall) {
      quantified("forall", forall.variables());
      end(forall.effect());
    } else if (effect instanceof Effect.Change change) {
      List<Expression> sides = List.of(change.fluent(), change.value());
      group(change.assignment().word(), sides, SlPrinter::write);
    } else if (effect instanceof Effect.SenseAtom sense) {
      group("sense", List.of(sense.atom()), SlPrinter::write);
    } else {
      group("sense", List.of(((Effect.SenseNumber) effect).fluent()), SlPrinter::write);
    }
  }

  private void write(Fact fact) {
    if (fact instanceof Fact.Holds holds) {
      write(holds.atom());
    } else if (fact instanceof Fact.Excluded excluded) {
      group("not", List.of(excluded.atom()), SlPrinter::write);
    } else if (fact instanceof Fact.Equation equation) {
      out.append("(= ");
      write(equation.fluent());
      out.append(' ');
      write(equation.value());
      out.append(')');
    } else {
      group("unknown", List.of(((Fact.Unknown) fact).atom()), SlPrinter::write);
    }
  }

  private void write(Content content) {
    group(content.operator(), content.arguments(), SlPrinter::write);
  }

  private void write(Content.Argument argument) {
    if (argument instanceof Content.Argument.OfFormula formula) {
      write(formula.formula());
    } else if (argument instanceof Content.Argument.OfTerm term) {
      write(term.term());
    } else if (argument instanceof Content.Argument.OfEffect effect) {
      write(effect.effect());
    } else if (argument instanceof Content.Argument.Nested nested) {
      write(nested.content());
    } else {
      Content.Argument.Named named = (Content.Argument.Named) argument;
      out.append("(:").append(named.name());
      operands(named.arguments(), SlPrinter::write);
    }
  }

  /** The beginning of a group, with the variables in parentheses that quantifiers have. */
  private void quantified(String head, List<TypedVariable> variables) {
    out.append('(').append(head).append(" (");
    list(variables, SlPrinter::write);
    out.append(')');
  }

  private void end(Formula last) {
    out.append(' ');
    write(last);
    out.append(')');
  }

  private void end(Effect last) {
    out.append(' ');
    write(last);
    out.append(')');
  }

  private <T> void group(String head, List<? extends T> parts, BiConsumer<SlPrinter, T> writer) {
    out.append('(').append(head);
    operands(parts, writer);
  }

  private <T> void operands(List<? extends T> parts, BiConsumer<SlPrinter, T> writer) {
    for (T part : parts) {
      out.append(' ');
      writer.accept(this, part);
    }
    out.append(')');
  }

  private <T> void list(List<? extends T> parts, BiConsumer<SlPrinter, T> writer) {
    String separator = "";
    for (T part : parts) {
      out.append(separator);
      writer.accept(this, part);
      separator = " ";
    }
  }
}
