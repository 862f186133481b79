package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.maestro.planning.api.PlannedSearch;
import org.maestro.sl.Term;

/**
 * A functional variable whose value nobody knows, while looks could find it.
 *
 * @param values those that a look can find, in the order of the operators
 */
public record Sought(Variable variable, List<Integer> values) {

  /** Whether there are so many places that not all can be weighed against each other. */
  public boolean isInManyPlaces() {
    return values.size() > PlannedSearch.MANY_PLACES;
  }

  public static boolean hasManyPlaces(Collection<Sought> all) {
    return all.stream().anyMatch(Sought::isInManyPlaces);
  }

  /** All that can be sought in the problem, in the order of its operators. */
  public static List<Sought> of(GroundProblem problem) {
    Map<Variable, Set<Integer>> values = new LinkedHashMap<>();
    for (Operator operator : problem.operators()) {
      for (Change change : operator.changes()) {
        if (change instanceof Change.Find find
            && find.variable().functional()
            && find.variable().isUnknown(find.variable().initialCode(), find.value())) {
          values.computeIfAbsent(find.variable(), v -> new LinkedHashSet<>()).add(find.value());
        }
      }
    }
    List<Sought> sought = new ArrayList<>();
    values.forEach((variable, found) -> sought.add(new Sought(variable, List.copyOf(found))));
    return sought;
  }

  /** The value that the operators find first, by their order; negative when they seek nothing. */
  public int firstLookedAt(List<Operator> operators) {
    for (Operator operator : operators) {
      for (int value : values) {
        if (looksAt(operator, value)) {
          return value;
        }
      }
    }
    return Variable.NONE;
  }

  public List<Term> terms() {
    return values.stream().map(variable::value).toList();
  }

  public boolean looksAt(Operator operator, int value) {
    return lookedAt(operator).anyMatch(found -> found == value);
  }

  /** The values that the operator can find. */
  public IntStream lookedAt(Operator operator) {
    return operator.changes().stream()
        .filter(change -> change instanceof Change.Find find && find.variable() == variable)
        .mapToInt(change -> ((Change.Find) change).value());
  }
}
