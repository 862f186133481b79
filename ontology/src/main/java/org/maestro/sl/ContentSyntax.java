package org.maestro.sl;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.function.Predicate;

/** Message content: operators with arguments of any kind. */
final class ContentSyntax {

  /** Inside an argument these words begin a content element even where an atom could stand. */
  private static final Set<String> OPERATORS =
      Set.of(
          "initCNP",
          "perform",
          "cancel",
          "query-if",
          "query-ref",
          "inform",
          "subscribe",
          "cost",
          "explain");

  private static final Set<String> EFFECT_WORDS =
      Set.of("assign", "increase", "decrease", "sense", "when");

  private static final Set<String> SHARED_WORDS = Set.of("and", "forall");

  private static final Set<String> FORMULA_WORDS =
      Set.of("or", "not", "imply", "exists", "unknown", "keep", "=", "<", "<=", ">", ">=");

  private final FormulaSyntax formulas;
  private final EffectSyntax effects;

  ContentSyntax(Predicate<String> fluents) {
    this.formulas = new FormulaSyntax(fluents);
    this.effects = new EffectSyntax(fluents);
  }

  List<Content> contents(String text) {
    return SlReader.readAll(unquoted(text), "a content element such as (initCNP ...)").stream()
        .map(this::content)
        .toList();
  }

  /** Quotes around the whole become blanks, so that columns stay what they are. */
  private static String unquoted(String text) {
    String inner = text;
    int quotes = 0;
    String trimmed = inner.strip();
    while (trimmed.length() >= 2 && isQuote(trimmed.charAt(0)) && isQuote(last(trimmed))) {
      int from = inner.indexOf(trimmed);
      int to = from + trimmed.length();
      inner = inner.substring(0, from) + " " + inner.substring(from + 1, to - 1) + " ";
      trimmed = inner.strip();
      quotes++;
    }
    return quotes == 0 ? text : inner.replace("\\\"", "\"");
  }

  private static char last(String text) {
    return text.charAt(text.length() - 1);
  }

  private static boolean isQuote(char c) {
    return c == '"' || c == '\u201c' || c == '\u201d';
  }

  Content content(Node node) {
    if (!(node instanceof Node.Group group) || group.children().isEmpty()) {
      throw node.fault("a content element such as (initCNP ...)");
    }
    String operator = ExpressionSyntax.name(group.children().get(0), "an operator");
    return new Content(operator, arguments(group.rest()));
  }

  private List<Content.Argument> arguments(List<Node> nodes) {
    List<Content.Argument> arguments = new ArrayList<>();
    int at = 0;
    while (at < nodes.size()) {
      Node node = nodes.get(at++);
      if (isKeyword(node)) {
        if (at == nodes.size() || isKeyword(nodes.get(at))) {
          throw node.fault("a value after " + node.shown() + ", and not another keyword,");
        }
        arguments.add(
            new Content.Argument.Named(
                ((Node.Leaf) node).text(), List.of(argument(nodes.get(at++)))));
      } else {
        arguments.add(argument(node));
      }
    }
    return arguments;
  }

  private static boolean isKeyword(Node node) {
    return node instanceof Node.Leaf leaf && leaf.kind() == Node.Kind.KEYWORD;
  }

  private Content.Argument argument(Node node) {
    if (node instanceof Node.Leaf || PointSyntax.begins(node)) {
      return new Content.Argument.OfTerm(ExpressionSyntax.term(node));
    }
    Node.Group group = (Node.Group) node;
    if (!group.children().isEmpty() && isKeyword(group.children().get(0))) {
      return new Content.Argument.Named(
          ((Node.Leaf) group.children().get(0)).text(), arguments(group.rest()));
    }
    String head = group.head();
    if (EFFECT_WORDS.contains(head)) {
      return new Content.Argument.OfEffect(effects.effect(group));
    }
    if (SHARED_WORDS.contains(head)) {
      return formulaOrEffect(group);
    }
    if (FORMULA_WORDS.contains(head) || OccasionSyntax.begins(group)) {
      return new Content.Argument.OfFormula(formulas.goal(group));
    }
    boolean onlyTerms =
        group.rest().stream()
            .allMatch(
                child ->
                    child instanceof Node.Leaf && !isKeyword(child) || PointSyntax.begins(child));
    return OPERATORS.contains(head) || !onlyTerms
        ? new Content.Argument.Nested(content(group))
        : new Content.Argument.OfFormula(FormulaSyntax.atom(group, "an argument"));
  }

  /** Reads it as the formula where both are possible, and reports the reading that got further. */
  private Content.Argument formulaOrEffect(Node.Group group) {
    try {
      return new Content.Argument.OfFormula(formulas.formula(group));
    } catch (SlSyntaxException asFormula) {
      try {
        return new Content.Argument.OfEffect(effects.effect(group));
      } catch (SlSyntaxException asEffect) {
        throw asEffect.column() > asFormula.column() ? asEffect : asFormula;
      }
    }
  }
}
