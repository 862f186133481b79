package org.maestro.planning.sensing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.planning.grounding.Chances;
import org.maestro.planning.optimal.RelaxedProblem;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Sought;

/**
 * The places where things that are sought are supposed to be: looks elsewhere are of use only once
 * that is known.
 *
 * @param places the value of each; negative: nowhere that can be looked at
 */
public record MostLikelyState(Map<Sought, Integer> places) {

  /**
   * That all is where it is likeliest, among what can be looked at; where places are alike, in the
   * one from which the goal is reached at the least cost, as is estimated. The problem's variables
   * are placed for it.
   *
   * @param relaxed of the problem
   */
  public static MostLikelyState likeliest(
      List<Sought> all, Chances chances, GroundProblem problem, RelaxedProblem relaxed) {
    Map<Sought, Integer> places = new LinkedHashMap<>();
    for (Sought sought : all) {
      List<Integer> alike = chances.likeliest(sought);
      int first =
          alike.size() == 1 ? alike.get(0) : new LookCosts(problem, relaxed, sought).leastOf(alike);
      places.put(sought, sought.values().get(first));
    }
    return new MostLikelyState(places);
  }

  public GroundProblem appliedTo(GroundProblem problem) {
    return problem.with(problem.operators().stream().map(this::restricted).toList());
  }

  /**
   * Where there are many places, looks elsewhere find nothing new: saying so makes the estimates of
   * large problems sharper, by which few states have to be seen.
   */
  private Operator restricted(Operator operator) {
    List<Condition> conditions = new ArrayList<>();
    List<Change> kept = new ArrayList<>();
    for (Change change : operator.changes()) {
      boolean elsewhere = change instanceof Change.Find find && isElsewhere(find);
      if (elsewhere) {
        Change.Find find = (Change.Find) change;
        conditions.add(
            new Condition.Literal(find.variable(), find.value(), Condition.Question.NOT_UNKNOWN));
      }
      if (!elsewhere || !Sought.hasManyPlaces(places.keySet())) {
        kept.add(change);
      }
    }
    if (conditions.isEmpty()) {
      return operator;
    }
    conditions.add(0, operator.precondition());
    return operator.withPrecondition(Condition.all(conditions)).withChanges(kept);
  }

  private boolean isElsewhere(Change.Find find) {
    return places.entrySet().stream()
        .anyMatch(
            entry ->
                entry.getKey().variable() == find.variable() && entry.getValue() != find.value());
  }
}
