package org.maestro.sl;

import java.util.List;
import java.util.function.Predicate;

/**
 * The one parser of MAESTRO-SL. Every method takes the whole text and throws {@link
 * SlSyntaxException} when it is anything else than asked for. Whether {@code (unknown (p x))} and
 * {@code (sense (p x))} speak of an atom or of a number cannot be seen from the text: the variants
 * with {@code fluents}, a test by name, tell; without it they are atoms. Nesting deeper than 100 is
 * refused.
 */
public final class SlParser {

  private static final Predicate<String> NO_FLUENTS = name -> false;

  private SlParser() {}

  /** A formula; {@code (keep ...)} is allowed around the whole. */
  public static Formula formula(String text) {
    return formula(text, NO_FLUENTS);
  }

  public static Formula formula(String text, Predicate<String> fluents) {
    return new FormulaSyntax(fluents).goal(SlReader.readOne(text, "a formula"));
  }

  public static Effect effect(String text) {
    return effect(text, NO_FLUENTS);
  }

  public static Effect effect(String text, Predicate<String> fluents) {
    return new EffectSyntax(fluents).effect(SlReader.readOne(text, "an effect"));
  }

  /** The body of a script. */
  public static Body body(String text, Predicate<String> fluents) {
    return new BodySyntax(fluents).body(SlReader.readOne(text, "a step"));
  }

  /** A number, a variable, a fluent or arithmetic. */
  public static Expression expression(String text) {
    return ExpressionSyntax.expression(SlReader.readOne(text, "a number or a fluent"));
  }

  public static Term term(String text) {
    return ExpressionSyntax.term(SlReader.readOne(text, "a term"));
  }

  /** A typed variable as it stands in a predicate's arguments, {@code ?x - Thing}. */
  public static TypedVariable variable(String text) {
    List<TypedVariable> variables =
        ExpressionSyntax.variables(
            SlReader.readAll(text, "a variable such as ?x"),
            text.length() + 1,
            "the end of the text");
    if (variables.size() > 1) {
      throw new SlSyntaxException(1, "one variable", variables.size() + " variables");
    }
    return variables.get(0);
  }

  /** A single statement, ground or a template. */
  public static Fact fact(String text) {
    Node node = SlReader.readOne(text, "a fact");
    if (!(node instanceof Node.Group group)) {
      throw node.fault("a fact such as (in Cup zone-a) or (= (level lamp-1) 0.5)");
    }
    return switch (group.head()) {
      case "not" -> {
        group.expectOperands(1, "an atom");
        yield new Fact.Excluded(FormulaSyntax.atom(group.rest().get(0), "an atom"));
      }
      case "unknown" -> {
        group.expectOperands(1, "an atom or a fluent");
        yield new Fact.Unknown(FormulaSyntax.atom(group.rest().get(0), "an atom or a fluent"));
      }
      case "=" -> {
        group.expectOperands(2, "a fluent and its value");
        yield new Fact.Equation(
            ExpressionSyntax.fluent(group.rest().get(0)),
            ExpressionSyntax.term(group.rest().get(1)));
      }
      default -> new Fact.Holds(FormulaSyntax.atom(group, "a fact"));
    };
  }

  /**
   * The content of a message, one or more elements; quotes around the whole are taken off, also
   * doubled ones.
   */
  public static List<Content> content(String text) {
    return content(text, NO_FLUENTS);
  }

  public static List<Content> content(String text, Predicate<String> fluents) {
    return new ContentSyntax(fluents).contents(text);
  }
}
