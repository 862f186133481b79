package org.maestro.sl;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** How an expression was understood: its parts below each other, each with what it is. */
public final class Outline {

  private final List<Line> lines = new ArrayList<>();

  /**
   * A part.
   *
   * @param depth of how many others it is a part
   * @param text as it is written
   * @param role what it is, or does, in the whole
   */
  public record Line(int depth, String text, String role) {}

  private Outline() {}

  /** The parts of a goal or condition. */
  public static List<Line> of(Formula formula) {
    Outline outline = new Outline();
    outline.formula(formula, 0);
    return List.copyOf(outline.lines);
  }

  /** The parts of an effect. */
  public static List<Line> of(Effect effect) {
    Outline outline = new Outline();
    outline.effect(effect, 0);
    return List.copyOf(outline.lines);
  }

  /** The parts of a number. */
  public static List<Line> of(Expression expression) {
    Outline outline = new Outline();
    outline.expression(expression, 0);
    return List.copyOf(outline.lines);
  }

  private void add(int depth, String text, String role) {
    lines.add(new Line(depth, text, role));
  }

  private void formula(Formula formula, int depth) {
    if (formula instanceof Formula.Atom atom) {
      word(atom.predicate(), "holds", atom.arguments(), depth);
    } else if (formula instanceof Formula.Exists exists) {
      add(depth, "exists" + variables(exists.variables()), "for one of these it holds that");
      formula(exists.body(), depth + 1);
    } else if (formula instanceof Formula.Forall forall) {
      add(depth, "forall" + variables(forall.variables()), "for each of these it holds that");
      formula(forall.body(), depth + 1);
    } else if (formula instanceof Formula.Comparison comparison) {
      add(depth, comparison.relation().symbol(), "compares both");
      expression(comparison.left(), depth + 1);
      expression(comparison.right(), depth + 1);
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      add(depth, "unknown", "nobody knows whether");
      formula(unknown.atom(), depth + 1);
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      add(depth, "unknown", "nobody knows the number");
      expression(unknown.fluent(), depth + 1);
    } else {
      connective(formula, depth);
    }
  }

  private void connective(Formula formula, int depth) {
    if (formula instanceof Formula.And) {
      add(depth, "and", "all of these");
    } else if (formula instanceof Formula.Or) {
      add(depth, "or", "one of these, or more");
    } else if (formula instanceof Formula.Not) {
      add(depth, "not", "this does not hold");
    } else if (formula instanceof Formula.Imply) {
      add(depth, "imply", "where the first holds, the second does");
    } else if (formula instanceof Formula.Bound bound) {
      add(depth, OccasionSyntax.begin(bound) + " ...)", role(bound));
    } else {
      add(depth, "keep", "is reached and then held");
    }
    formula.parts().forEach(part -> formula(part, depth + 1));
  }

  private static String role(Formula.Bound bound) {
    if (bound instanceof Formula.Until) {
      return "until then, the goal";
    }
    if (bound.occasion() instanceof Occasion.Event event) {
      return event.again()
          ? "each time that the first becomes so, the goal"
          : "as soon as the first is so, the goal";
    }
    return "then, the goal";
  }

  private void effect(Effect effect, int depth) {
    if (effect instanceof Effect.Add add) {
      word(add.atom().predicate(), "begins to hold", add.atom().arguments(), depth);
    } else if (effect instanceof Effect.Delete delete) {
      word(delete.atom().predicate(), "ceases to hold", delete.atom().arguments(), depth);
    } else if (effect instanceof Effect.All all) {
      add(depth, "and", "all of these");
      all.effects().forEach(part -> effect(part, depth + 1));
    } else if (effect instanceof Effect.When when) {
      add(depth, "when", "if the first holds, the second happens");
      formula(when.condition(), depth + 1);
      effect(when.effect(), depth + 1);
    } else if (effect instanceof Effect.Forall forall) {
      add(depth, "forall" + variables(forall.variables()), "for each of these");
      effect(forall.effect(), depth + 1);
    } else if (effect instanceof Effect.Change change) {
      String assignment = change.assignment().name().toLowerCase(Locale.ROOT);
      add(depth, assignment, "changes the number by, or to, the second");
      expression(change.fluent(), depth + 1);
      expression(change.value(), depth + 1);
    } else if (effect instanceof Effect.SenseAtom sense) {
      add(depth, "sense", "finds out whether");
      formula(sense.atom(), depth + 1);
    } else if (effect instanceof Effect.SenseNumber sense) {
      add(depth, "sense", "finds out the number");
      expression(sense.fluent(), depth + 1);
    }
  }

  private void expression(Expression expression, int depth) {
    if (expression instanceof Expression.OfTerm ofTerm) {
      term(ofTerm.term(), depth);
    } else if (expression instanceof Expression.Fluent fluent) {
      word(fluent.name(), "a number", fluent.arguments(), depth);
    } else if (expression instanceof Expression.Arithmetic arithmetic) {
      add(depth, arithmetic.operator().symbol(), "reckons with these");
      arithmetic.operands().forEach(operand -> expression(operand, depth + 1));
    }
  }

  private void word(String word, String role, List<Term> arguments, int depth) {
    add(depth, word, role);
    arguments.forEach(argument -> term(argument, depth + 1));
  }

  private void term(Term term, int depth) {
    String role =
        term instanceof Term.Variable
            ? "whichever fits"
            : term instanceof Term.Name
                ? "a name"
                : term instanceof Term.Number
                    ? "a number"
                    : term instanceof Term.Text
                        ? "a text"
                        : term instanceof Term.Truth ? "a truth value" : "an IRI";
    add(depth, SlPrinter.print(term), role);
  }

  private static String variables(List<TypedVariable> variables) {
    return variables.stream()
        .map(variable -> " " + SlPrinter.print(variable))
        .collect(Collectors.joining());
  }
}
