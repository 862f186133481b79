package org.maestro.planning.ground;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** A lower bound on a schema instance's cost, as a common number: fast, for orders and bounds. */
final class LeastCosts {
  private final LiftedTask task;
  private final boolean[] changing;
  private final List<List<Part>> parts = new ArrayList<>();

  /** An amount that is part of the cost, with its factor. */
  private record Part(Amount amount, double factor) {}

  LeastCosts(LiftedTask task) {
    this.task = task;
    changing = new boolean[task.functions().size()];
    for (Schema schema : task.schemas()) {
      schema.increases().forEach(increase -> changing[increase.function().symbol()] = true);
      parts.add(
          schema.increases().stream().flatMap(increase -> partOfCost(increase).stream()).toList());
    }
  }

  private Optional<Part> partOfCost(Schema.Increase increase) {
    return Optional.ofNullable(task.metric().get(increase.function().symbol()))
        .map(factor -> new Part(increase.amount(), factor.doubleValue()));
  }

  /**
   * The cost, or less where it is not known; 0 for goals.
   *
   * @param schema the number of the schema
   */
  double of(int schema, int[] binding) {
    if (schema >= parts.size()) {
      return 0;
    }
    if (task.metric().isEmpty()) {
      return 1;
    }
    double cost = 0;
    for (Part part : parts.get(schema)) {
      cost += part.factor() * value(part.amount(), binding);
    }
    return cost > 0 ? cost : 0;
  }

  /** Not a number where there is none, or where it changes: then nothing is known of the cost. */
  private double value(Amount amount, int[] binding) {
    if (amount instanceof Amount.Constant constant) {
      return constant.value().doubleValue();
    }
    if (amount instanceof Amount.Value value) {
      Atom function = value.function();
      BigDecimal now =
          changing[function.symbol()]
              ? null
              : task.values().get(new Atom(function.symbol(), function.ground(binding)));
      return now == null ? Double.NaN : now.doubleValue();
    }
    Amount.Operation operation = (Amount.Operation) amount;
    double left = value(operation.left(), binding);
    double right = value(operation.right(), binding);
    return switch (operation.operator()) {
      case '+' -> left + right;
      case '-' -> left - right;
      case '*' -> left * right;
      default -> right == 0 ? Double.NaN : left / right;
    };
  }
}
