package org.maestro.sl;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Terms, numbers and typed variables. */
final class ExpressionSyntax {

  private static final Map<String, Expression.Operator> OPERATORS = operators();

  private ExpressionSyntax() {}

  private static Map<String, Expression.Operator> operators() {
    Map<String, Expression.Operator> bySymbol = new LinkedHashMap<>();
    for (Expression.Operator operator : Expression.Operator.values()) {
      bySymbol.put(operator.symbol(), operator);
    }
    return bySymbol;
  }

  static Term term(Node node) {
    if (PointSyntax.begins(node)) {
      return PointSyntax.name(node);
    }
    if (!(node instanceof Node.Leaf leaf)) {
      throw node.fault("a term");
    }
    return switch (leaf.kind()) {
      case VARIABLE -> new Term.Variable(leaf.text());
      case STRING -> new Term.Text(leaf.text());
      case IRI -> new Term.Iri(leaf.text());
      case NUMBER -> new Term.Number(Double.parseDouble(leaf.text()));
      case KEYWORD -> throw leaf.fault("a term");
      case WORD -> word(leaf);
    };
  }

  private static Term word(Node.Leaf leaf) {
    if (leaf.text().equals("true") || leaf.text().equals("false")) {
      return new Term.Truth(leaf.text().equals("true"));
    }
    return new Term.Name(name(leaf, "a term"));
  }

  /** A bare name; the signs of arithmetic and comparison are none. */
  static String name(Node node, String expected) {
    if (node instanceof Node.Leaf leaf
        && leaf.kind() == Node.Kind.WORD
        && SlReader.isName(leaf.text())) {
      return leaf.text();
    }
    throw node.fault(expected);
  }

  static List<Term> terms(List<Node> nodes) {
    return nodes.stream().map(ExpressionSyntax::term).toList();
  }

  /** Either side of an equality: any term, or an expression. */
  static Expression operand(Node node) {
    return node instanceof Node.Leaf || PointSyntax.begins(node)
        ? new Expression.OfTerm(term(node))
        : expression(node);
  }

  static Expression expression(Node node) {
    if (node instanceof Node.Leaf leaf) {
      if (leaf.kind() != Node.Kind.NUMBER && leaf.kind() != Node.Kind.VARIABLE) {
        throw leaf.fault("a number, a variable or a fluent in parentheses");
      }
      return new Expression.OfTerm(term(leaf));
    }
    Node.Group group = (Node.Group) node;
    Expression.Operator operator = OPERATORS.get(group.head());
    if (operator == null) {
      return fluent(group);
    }
    if (group.rest().isEmpty()) {
      group.expectOperands(1, "a number");
    }
    return new Expression.Arithmetic(
        operator, group.rest().stream().map(ExpressionSyntax::expression).toList());
  }

  static Expression.Fluent fluent(Node node) {
    Formula.Atom atom = FormulaSyntax.atom(node, "a fluent such as (illuminance zone-a)");
    return new Expression.Fluent(atom.predicate(), atom.arguments());
  }

  static List<TypedVariable> variables(Node node) {
    if (!(node instanceof Node.Group group) || group.children().isEmpty()) {
      throw node.fault("variables in parentheses such as (?x - Thing)");
    }
    return variables(group.children(), group.end(), "\")\"");
  }

  /** Reads variables up to where stands what {@code closing} names. */
  static List<TypedVariable> variables(List<Node> nodes, int end, String closing) {
    List<TypedVariable> variables = new ArrayList<>();
    int at = 0;
    while (at < nodes.size()) {
      if (!(nodes.get(at) instanceof Node.Leaf leaf) || leaf.kind() != Node.Kind.VARIABLE) {
        throw nodes.get(at).fault("a variable such as ?x");
      }
      at++;
      Optional<String> className = Optional.empty();
      if (at < nodes.size() && isDash(nodes.get(at))) {
        if (at + 1 == nodes.size()) {
          throw new SlSyntaxException(end, "a class name", closing);
        }
        className = Optional.of(name(nodes.get(at + 1), "a class name"));
        at += 2;
      }
      variables.add(new TypedVariable(leaf.text(), className));
    }
    return variables;
  }

  private static boolean isDash(Node node) {
    return node instanceof Node.Leaf leaf
        && leaf.kind() == Node.Kind.WORD
        && leaf.text().equals("-");
  }
}
