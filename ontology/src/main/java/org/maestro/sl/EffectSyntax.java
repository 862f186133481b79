package org.maestro.sl;

import java.util.List;
import java.util.function.Predicate;

/** Effects. Which names are fluents decides how {@code (sense ...)} is read. */
final class EffectSyntax {

  private static final String AN_EFFECT = "an effect";

  private final Predicate<String> fluents;
  private final FormulaSyntax formulas;

  EffectSyntax(Predicate<String> fluents) {
    this.fluents = fluents;
    this.formulas = new FormulaSyntax(fluents);
  }

  Effect effect(Node node) {
    if (!(node instanceof Node.Group group)) {
      throw node.fault(AN_EFFECT);
    }
    return switch (group.head()) {
      case "not" -> {
        group.expectOperands(1, "an atom");
        yield new Effect.Delete(FormulaSyntax.atom(group.rest().get(0), "an atom"));
      }
      case "and" -> new Effect.All(group.rest().stream().map(this::effect).toList());
      case "when" -> {
        group.expectOperands(2, "a formula and an effect");
        yield new Effect.When(formulas.formula(group.rest().get(0)), effect(group.rest().get(1)));
      }
      case "forall" -> {
        group.expectOperands(2, "variables and an effect");
        yield new Effect.Forall(
            ExpressionSyntax.variables(group.rest().get(0)), effect(group.rest().get(1)));
      }
      case "assign" -> change(Effect.Assignment.ASSIGN, group);
      case "increase" -> change(Effect.Assignment.INCREASE, group);
      case "decrease" -> change(Effect.Assignment.DECREASE, group);
      case "sense" -> sense(group);
      default -> new Effect.Add(FormulaSyntax.atom(group, AN_EFFECT));
    };
  }

  private static Effect change(Effect.Assignment assignment, Node.Group group) {
    group.expectOperands(2, "a fluent and a number");
    return new Effect.Change(
        assignment,
        ExpressionSyntax.fluent(group.rest().get(0)),
        ExpressionSyntax.expression(group.rest().get(1)));
  }

  private Effect sense(Node.Group group) {
    if (group.rest().isEmpty()) {
      group.expectOperands(1, "an atom or a fluent");
    }
    List<Effect> senses = group.rest().stream().map(this::sensed).toList();
    return senses.size() == 1 ? senses.get(0) : new Effect.All(senses);
  }

  private Effect sensed(Node node) {
    Formula.Atom atom = FormulaSyntax.atom(node, "an atom or a fluent");
    return fluents.test(atom.predicate())
        ? new Effect.SenseNumber(new Expression.Fluent(atom.predicate(), atom.arguments()))
        : new Effect.SenseAtom(atom);
  }
}
