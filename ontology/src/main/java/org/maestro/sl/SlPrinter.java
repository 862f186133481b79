package org.maestro.sl;

import java.math.BigDecimal;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * Prints trees as MAESTRO-SL; the inverse of {@link SlParser}. Numbers are written shortest: {@code
 * 17}, {@code 0.25}.
 */
public final class SlPrinter {

  private static final double LARGEST_PLAIN = 1e15;
  private static final double SMALLEST_PLAIN = 1e-6;

  private SlPrinter() {}

  public static String print(Term term) {
    if (term instanceof Term.Variable variable) {
      return "?" + variable.name();
    } else if (term instanceof Term.Name name) {
      return name.text();
    } else if (term instanceof Term.Iri iri) {
      return "<" + iri.text() + ">";
    } else if (term instanceof Term.Number number) {
      return print(number.value());
    } else if (term instanceof Term.Text text) {
      return "\"" + text.value().replace("\\", "\\\\").replace("\"", "\\\"") + "\"";
    }
    return String.valueOf(((Term.Truth) term).value());
  }

  /** A finite number without needless digits. */
  public static String print(double value) {
    if (value == Math.rint(value) && Math.abs(value) < LARGEST_PLAIN) {
      return value == 0 && 1 / value < 0 ? "-0" : String.valueOf((long) value);
    }
    return Math.abs(value) < LARGEST_PLAIN && Math.abs(value) >= SMALLEST_PLAIN
        ? new BigDecimal(Double.toString(value)).toPlainString()
        : Double.toString(value);
  }

  public static String print(TypedVariable variable) {
    return "?" + variable.name() + variable.className().map(name -> " - " + name).orElse("");
  }

  public static String print(Expression expression) {
    if (expression instanceof Expression.OfTerm ofTerm) {
      return print(ofTerm.term());
    } else if (expression instanceof Expression.Fluent fluent) {
      return applied(fluent.name(), fluent.arguments());
    }
    Expression.Arithmetic arithmetic = (Expression.Arithmetic) expression;
    return group(arithmetic.operator().symbol(), arithmetic.operands(), SlPrinter::print);
  }

  public static String print(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      return applied(atom.predicate(), atom.arguments());
    } else if (formula instanceof Formula.And and) {
      return group("and", and.operands(), SlPrinter::print);
    } else if (formula instanceof Formula.Or or) {
      return group("or", or.operands(), SlPrinter::print);
    } else if (formula instanceof Formula.Not not) {
      return "(not " + print(not.operand()) + ")";
    } else if (formula instanceof Formula.Imply imply) {
      return "(imply " + print(imply.premise()) + " " + print(imply.conclusion()) + ")";
    } else if (formula instanceof Formula.Exists exists) {
      return "(exists " + print(exists.variables()) + " " + print(exists.body()) + ")";
    } else if (formula instanceof Formula.Forall forall) {
      return "(forall " + print(forall.variables()) + " " + print(forall.body()) + ")";
    } else if (formula instanceof Formula.Comparison comparison) {
      String sides = print(comparison.left()) + " " + print(comparison.right());
      return "(" + comparison.relation().symbol() + " " + sides + ")";
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      return "(unknown " + print(unknown.atom()) + ")";
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      return "(unknown " + print(unknown.fluent()) + ")";
    }
    return "(keep " + print(((Formula.Keep) formula).body()) + ")";
  }

  public static String print(Effect effect) {
    if (effect instanceof Effect.Add add) {
      return print(add.atom());
    } else if (effect instanceof Effect.Delete delete) {
      return "(not " + print(delete.atom()) + ")";
    } else if (effect instanceof Effect.All all) {
      return group("and", all.effects(), SlPrinter::print);
    } else if (effect instanceof Effect.When when) {
      return "(when " + print(when.condition()) + " " + print(when.effect()) + ")";
    } else if (effect instanceof Effect.Forall forall) {
      return "(forall " + print(forall.variables()) + " " + print(forall.effect()) + ")";
    } else if (effect instanceof Effect.Change change) {
      String sides = print(change.fluent()) + " " + print(change.value());
      return "(" + change.assignment().word() + " " + sides + ")";
    } else if (effect instanceof Effect.SenseAtom sense) {
      return "(sense " + print(sense.atom()) + ")";
    }
    return "(sense " + print(((Effect.SenseNumber) effect).fluent()) + ")";
  }

  public static String print(Fact fact) {
    if (fact instanceof Fact.Holds holds) {
      return print(holds.atom());
    } else if (fact instanceof Fact.Excluded excluded) {
      return "(not " + print(excluded.atom()) + ")";
    } else if (fact instanceof Fact.Equation equation) {
      return "(= " + print(equation.fluent()) + " " + print(equation.value()) + ")";
    }
    return "(unknown " + print(((Fact.Unknown) fact).atom()) + ")";
  }

  public static String print(Content content) {
    return group(content.operator(), content.arguments(), SlPrinter::print);
  }

  public static String print(Content.Argument argument) {
    if (argument instanceof Content.Argument.OfFormula formula) {
      return print(formula.formula());
    } else if (argument instanceof Content.Argument.OfTerm term) {
      return print(term.term());
    } else if (argument instanceof Content.Argument.OfEffect effect) {
      return print(effect.effect());
    } else if (argument instanceof Content.Argument.Nested nested) {
      return print(nested.content());
    }
    Content.Argument.Named named = (Content.Argument.Named) argument;
    return group(":" + named.name(), named.arguments(), SlPrinter::print);
  }

  /** Variables in parentheses, as quantifiers have them. */
  private static String print(List<TypedVariable> variables) {
    return variables.stream().map(SlPrinter::print).collect(Collectors.joining(" ", "(", ")"));
  }

  private static String applied(String name, List<Term> arguments) {
    return group(name, arguments, SlPrinter::print);
  }

  private static <T> String group(String head, List<T> parts, Function<T, String> printed) {
    return Stream.concat(Stream.of(head), parts.stream().map(printed))
        .collect(Collectors.joining(" ", "(", ")"));
  }
}
