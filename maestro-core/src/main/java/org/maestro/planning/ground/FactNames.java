package org.maestro.planning.ground;

import java.util.Arrays;
import java.util.Map;
import java.util.stream.Collectors;

/** The names of a ground task's facts and operators. */
record FactNames(
    LiftedTask task,
    Relation[] relations,
    boolean[] changing,
    int[] firstFact,
    Map<Integer, Integer> opposites)
    implements GroundTask.Names {
  @Override
  public String fact(int fact) {
    for (Map.Entry<Integer, Integer> opposite : opposites.entrySet()) {
      if (opposite.getValue() == fact) {
        return "(not " + fact(opposite.getKey()) + ")";
      }
    }
    for (int symbol = relations.length - 1; symbol >= 0; symbol--) {
      int number = fact - firstFact[symbol];
      if (changing[symbol] && number >= 0 && number < relations[symbol].size()) {
        return words(task.predicates().get(symbol), relations[symbol].tuple(number));
      }
    }
    return "(goal)";
  }

  @Override
  public String operator(GroundOperator operator) {
    if (task.isGoal(operator.schema())) {
      return "";
    }
    Schema schema = task.schemas().get(operator.schema());
    return words(schema.name(), Arrays.copyOf(operator.arguments(), schema.shown()));
  }

  private String words(String head, int[] objects) {
    return Arrays.stream(objects)
        .mapToObj(object -> " " + task.objects().get(object))
        .collect(Collectors.joining("", "(" + head, ")"));
  }
}
