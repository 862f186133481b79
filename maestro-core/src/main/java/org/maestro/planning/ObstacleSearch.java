package org.maestro.planning;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.planning.PlanningResult.Explanation;
import org.maestro.planning.PlanningResult.Obstacle;

/**
 * Finds what stands in the way of a goal that not even the relaxation reaches: conditions that
 * nobody can bring about, but with which the goal would be in reach, none of them superfluous.
 * Where several sets would do, numbers are preferred to what has been seen not to be, and that to
 * what no agent ever changes.
 */
final class ObstacleSearch {
  /** Any assumption weighs more than any number of steps. */
  private static final double ASSUMPTION = 1e6;

  private static final int INITIAL = -1;
  private static final int ASSUMED = -2;

  private final RelaxedProblem relaxed;
  private final State initial;
  private final double[] costs;
  private final double[] value;
  private final int[] supporter;

  private ObstacleSearch(RelaxedProblem relaxed) {
    this.relaxed = relaxed;
    this.initial = relaxed.problem().initial();
    this.costs = relaxed.costs(initial);
    this.value = new double[relaxed.propositionCount()];
    this.supporter = new int[value.length];
  }

  /** The obstacles; none when the goal is false whatever one assumes. */
  static Explanation explanation(RelaxedProblem relaxed) {
    return new ObstacleSearch(relaxed).explain();
  }

  private Explanation explain() {
    boolean[] reached = relaxed.reachable(initial);
    for (boolean rootsOnly : new boolean[] {true, false}) {
      computeSums(reached, rootsOnly);
      if (Double.isFinite(value[relaxed.goal()])) {
        Map<Integer, String> assumed = new LinkedHashMap<>();
        collect(relaxed.goal(), "the goal", assumed, new boolean[value.length]);
        return new Explanation(obstacles(minimal(assumed)));
      }
    }
    return new Explanation(List.of());
  }

  /** The additive heuristic, where conditions out of reach may be assumed. */
  private void computeSums(boolean[] reached, boolean rootsOnly) {
    boolean[] truths = relaxed.truths(initial);
    Arrays.fill(value, Double.POSITIVE_INFINITY);
    for (int i = 0; i < value.length; i++) {
      if (truths[i]) {
        value[i] = 0;
        supporter[i] = INITIAL;
      } else if (!reached[i]
          && mayBeAssumed(relaxed.leaf(i))
          && !(rootsOnly && hasAchiever(i) && !isOfKnownNumber(relaxed.leaf(i)))) {
        value[i] = ASSUMPTION * weight(relaxed.leaf(i));
        supporter[i] = ASSUMED;
      }
    }
    boolean changed = true;
    while (changed) {
      changed = false;
      for (int i = 0; i < relaxed.actions().size(); i++) {
        RelaxedProblem.Action action = relaxed.actions().get(i);
        double sum = action.payer() == RelaxedProblem.FREE ? 0 : costs[action.payer()];
        for (int needed : action.preconditions()) {
          sum += value[needed];
        }
        for (int added : action.additions()) {
          if (sum < value[added]) {
            value[added] = sum;
            supporter[added] = i;
            changed = true;
          }
        }
      }
    }
  }

  /** That a number were unknown is nothing to wish for. */
  private static boolean mayBeAssumed(Condition leaf) {
    return leaf != Condition.Constant.FALSE
        && !(leaf instanceof Condition.NumberKnown number && !number.known());
  }

  /** Such a comparison is never reached by measuring. */
  private boolean isOfKnownNumber(Condition leaf) {
    Threshold threshold = leaf instanceof Condition.Compare compare ? Threshold.of(compare) : null;
    return threshold != null && !Quantity.isUnknown(initial.number(threshold.variable()));
  }

  private boolean hasAchiever(int proposition) {
    return relaxed.actions().stream()
        .filter(a -> a.payer() == RelaxedProblem.FREE || Double.isFinite(costs[a.payer()]))
        .anyMatch(a -> Arrays.stream(a.additions()).anyMatch(added -> added == proposition));
  }

  private static double weight(Condition leaf) {
    if (leaf instanceof Condition.Compare) {
      return 1;
    } else if (leaf instanceof Condition.Fixed) {
      return 1.5;
    }
    return leaf instanceof Condition.Literal literal && literal.variable().observable() ? 2 : 3;
  }

  private void collect(
      int proposition, String neededBy, Map<Integer, String> assumed, boolean[] seen) {
    if (seen[proposition]) {
      return;
    }
    seen[proposition] = true;
    if (supporter[proposition] == ASSUMED) {
      assumed.put(proposition, neededBy);
    } else if (supporter[proposition] != INITIAL) {
      RelaxedProblem.Action action = relaxed.actions().get(supporter[proposition]);
      List<Operator> operators = relaxed.problem().operators();
      boolean isStep = action.payer() >= 0 && action.payer() < operators.size();
      String consumer = isStep ? StepSentence.of(operators.get(action.payer())) : neededBy;
      for (int needed : action.preconditions()) {
        collect(needed, consumer, assumed, seen);
      }
    }
  }

  private Map<Integer, String> minimal(Map<Integer, String> assumed) {
    Map<Integer, String> kept = new LinkedHashMap<>(assumed);
    for (int candidate : assumed.keySet()) {
      boolean[] truths = relaxed.truths(initial);
      kept.keySet().stream().filter(p -> p != candidate).forEach(p -> truths[p] = true);
      if (relaxed.reachable(truths, costs)[relaxed.goal()]) {
        kept.remove(candidate);
      }
    }
    return kept;
  }

  private List<Obstacle> obstacles(Map<Integer, String> assumed) {
    List<Obstacle> obstacles = new ArrayList<>();
    assumed.forEach(
        (proposition, neededBy) ->
            obstacles.add(
                ObstacleText.obstacle(
                    relaxed.leaf(proposition), initial, relaxed.settings(), neededBy)));
    return obstacles.stream().distinct().toList();
  }
}
