package org.maestro.planning.ground;

import java.math.BigDecimal;
import java.util.List;
import java.util.Map;

/**
 * A planning task whose operators have parameters.
 *
 * @param objects names, by number
 * @param predicates names, by number
 * @param functions names, by number
 * @param initial what holds at first; all else does not
 * @param values of functions at first; a function without a value makes what needs it impossible
 * @param goals schemas without effects: what has to hold at the end, one of them for some binding
 *     of its parameters; at least one
 * @param metric what is to be least: a factor for each function without parameters; empty when each
 *     step costs 1
 */
public record LiftedTask(
    List<String> objects,
    List<String> predicates,
    List<String> functions,
    List<Schema> schemas,
    List<Atom> initial,
    Map<Atom, BigDecimal> values,
    List<Schema> goals,
    Map<Integer, BigDecimal> metric) {
  public LiftedTask {
    objects = List.copyOf(objects);
    predicates = List.copyOf(predicates);
    functions = List.copyOf(functions);
    schemas = List.copyOf(schemas);
    initial = List.copyOf(initial);
    values = Map.copyOf(values);
    goals = List.copyOf(goals);
    metric = Map.copyOf(metric);
  }

  /** Whether it is a goal's number: they follow those of the schemas. */
  boolean isGoal(int schema) {
    return schema >= schemas.size();
  }

  /** The schema or goal of that number. */
  Schema schema(int number) {
    return isGoal(number) ? goals.get(number - schemas.size()) : schemas.get(number);
  }
}
