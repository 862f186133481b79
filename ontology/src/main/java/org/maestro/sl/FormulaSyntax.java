package org.maestro.sl;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Predicate;

/** Formulas. Which names are fluents decides how {@code (unknown ...)} is read. */
final class FormulaSyntax {

  private static final String A_FORMULA = "a formula";

  /** Words that begin a form of the language and so cannot name a predicate. */
  private static final Set<String> RESERVED =
      Set.of(
          "and",
          "or",
          "not",
          "imply",
          "exists",
          "forall",
          "unknown",
          "keep",
          "when",
          "assign",
          "increase",
          "decrease",
          "sense",
          "min",
          "max",
          "true",
          "false");

  private static final Map<String, Formula.Relation> RELATIONS = relations();

  private final Predicate<String> fluents;

  FormulaSyntax(Predicate<String> fluents) {
    this.fluents = fluents;
  }

  private static Map<String, Formula.Relation> relations() {
    Map<String, Formula.Relation> bySymbol = new LinkedHashMap<>();
    for (Formula.Relation relation : Formula.Relation.values()) {
      bySymbol.put(relation.symbol(), relation);
    }
    return bySymbol;
  }

  /** A goal: a formula, one to be kept, or either bound to a time or an event. */
  Formula goal(Node node) {
    if (node instanceof Node.Group group && OccasionSyntax.begins(group)) {
      return new OccasionSyntax(this::formula, this::goal).bound(group);
    }
    if (node instanceof Node.Group group && group.head().equals("keep")) {
      group.expectOperands(1, A_FORMULA);
      return new Formula.Keep(formula(group.rest().get(0)));
    }
    return formula(node);
  }

  Formula formula(Node node) {
    if (!(node instanceof Node.Group group)) {
      throw node.fault(A_FORMULA);
    }
    Formula.Relation relation = RELATIONS.get(group.head());
    return relation == null ? connective(group) : comparison(relation, group);
  }

  private Formula connective(Node.Group group) {
    return switch (group.head()) {
      case "and" -> new Formula.And(formulas(group.rest()));
      case "or" -> new Formula.Or(formulas(group.rest()));
      case "not" -> {
        group.expectOperands(1, A_FORMULA);
        yield new Formula.Not(formula(group.rest().get(0)));
      }
      case "imply" -> {
        group.expectOperands(2, A_FORMULA);
        yield new Formula.Imply(formula(group.rest().get(0)), formula(group.rest().get(1)));
      }
      case "exists" -> {
        group.expectOperands(2, "variables and a formula");
        yield new Formula.Exists(
            ExpressionSyntax.variables(group.rest().get(0)), formula(group.rest().get(1)));
      }
      case "forall" -> {
        group.expectOperands(2, "variables and a formula");
        yield new Formula.Forall(
            ExpressionSyntax.variables(group.rest().get(0)), formula(group.rest().get(1)));
      }
      case "unknown" -> {
        group.expectOperands(1, "an atom or a fluent");
        yield unknown(atom(group.rest().get(0), "an atom or a fluent"));
      }
      case "keep" -> throw group.fault("\"keep\" only around a whole goal, and " + A_FORMULA);
      default -> {
        if (OccasionSyntax.begins(group)) {
          throw group.fault("\"" + group.head() + "\" only around a whole goal, and " + A_FORMULA);
        }
        yield atom(group, A_FORMULA);
      }
    };
  }

  private Formula unknown(Formula.Atom atom) {
    return fluents.test(atom.predicate())
        ? new Formula.UnknownNumber(new Expression.Fluent(atom.predicate(), atom.arguments()))
        : new Formula.UnknownAtom(atom);
  }

  private List<Formula> formulas(List<Node> nodes) {
    return nodes.stream().map(this::formula).toList();
  }

  private static Formula comparison(Formula.Relation relation, Node.Group group) {
    group.expectOperands(2, "two operands");
    Node left = group.rest().get(0);
    Node right = group.rest().get(1);
    return relation == Formula.Relation.EQUAL
        ? new Formula.Comparison(
            relation, ExpressionSyntax.operand(left), ExpressionSyntax.operand(right))
        : new Formula.Comparison(
            relation, ExpressionSyntax.expression(left), ExpressionSyntax.expression(right));
  }

  static Formula.Atom atom(Node node, String expected) {
    if (!(node instanceof Node.Group group)) {
      throw node.fault(expected);
    }
    if (group.children().isEmpty() || RESERVED.contains(group.head())) {
      throw group.fault(expected);
    }
    String predicate = ExpressionSyntax.name(group.children().get(0), expected);
    return new Formula.Atom(predicate, ExpressionSyntax.terms(group.rest()));
  }
}
