package org.maestro.planning.unsolvable;

import java.util.Arrays;
import java.util.Map;
import java.util.stream.Collectors;
import org.maestro.planning.ground.Amount;
import org.maestro.planning.ground.Atom;
import org.maestro.planning.ground.Comparison;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.ground.Literal;
import org.maestro.planning.ground.Schema;

/** Conditions and steps as PDDL writes them; an object that is open is a question mark. */
record Words(LiftedTask task) {
  private static final Map<Comparison.Relation, String> RELATIONS =
      Map.of(
          Comparison.Relation.LESS, "<",
          Comparison.Relation.AT_MOST, "<=",
          Comparison.Relation.EQUAL, "=",
          Comparison.Relation.AT_LEAST, ">=",
          Comparison.Relation.MORE, ">");

  String literal(Literal literal, int[] binding) {
    String atom = fact(literal.atom().symbol(), Binding.objects(literal.atom(), binding));
    return literal.positive() ? atom : "(not " + atom + ")";
  }

  private String fact(int predicate, int[] objects) {
    return list(task.predicates().get(predicate), objects);
  }

  String step(Schema schema, int[] binding) {
    return list(schema.name(), Arrays.copyOf(binding, schema.shown()));
  }

  String comparison(Comparison comparison, int[] binding) {
    return "(%s %s %s)"
        .formatted(
            RELATIONS.get(comparison.relation()),
            amount(comparison.left(), binding),
            amount(comparison.right(), binding));
  }

  private String amount(Amount amount, int[] binding) {
    if (amount instanceof Amount.Constant constant) {
      return constant.value().toPlainString();
    } else if (amount instanceof Amount.Value value) {
      Atom function = value.function();
      return list(task.functions().get(function.symbol()), Binding.objects(function, binding));
    }
    Amount.Operation operation = (Amount.Operation) amount;
    return "(%s %s %s)"
        .formatted(
            operation.operator(),
            amount(operation.left(), binding),
            amount(operation.right(), binding));
  }

  private String list(String head, int[] objects) {
    return Arrays.stream(objects)
        .mapToObj(object -> object < 0 ? " ?" : " " + task.objects().get(object))
        .collect(Collectors.joining("", "(" + head, ")"));
  }
}
