package org.maestro.planning.optimal;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.planning.api.OpenPrice;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Successors;
import org.maestro.sl.Term;

/**
 * The steps that may stand in a plan as cheap as the one found, and whose prices are lower bounds
 * as well: when that plan turns out to be dearer, one of these is likely to be what is asked for
 * next. They are steps that can be taken now, and those by which others would do what an open step
 * of the plan does.
 */
public final class RivalSteps {
  private static final double ROUNDING = 1e-6;

  /** What is done, whoever does it and wherever. */
  private record Deed(String feature, Map<String, Term> inputs) {
    static Deed of(FeatureType feature, Map<String, Term> bindings) {
      Map<String, Term> inputs = new HashMap<>(bindings);
      inputs.keySet().retainAll(feature.inputs().stream().map(Parameter::name).toList());
      return new Deed(feature.name(), inputs);
    }
  }

  private record Rival(boolean isPossibleNow, double planAtLeast, OpenPrice price) {}

  private final GroundProblem problem;
  private final Set<StepKey> taken = new HashSet<>();
  private final Set<Deed> deeds = new HashSet<>();
  private final double cost;

  private RivalSteps(GroundProblem problem, Plan plan) {
    this.problem = problem.placed();
    this.cost = plan.cost();
    for (Step step : plan.steps()) {
      taken.add(step.key());
      if (!step.exactPrice()) {
        deeds.add(Deed.of(step.feature(), step.bindings()));
      }
    }
  }

  /**
   * Those of the problem, first the steps that can be taken now, whose members know best what they
   * cost, and among equals by what a plan costs at least that takes them. None where all prices of
   * the plan are exact. The problem's variables are placed for it.
   */
  public static List<OpenPrice> of(GroundProblem problem, Plan plan) {
    RivalSteps rivals = new RivalSteps(problem, plan);
    return rivals.deeds.isEmpty() || problem.operators().stream().noneMatch(rivals::isRival)
        ? List.of()
        : rivals.inOrder();
  }

  private List<OpenPrice> inOrder() {
    CostBounds bounds = new CostBounds(problem, new RelaxedProblem(problem));
    if (bounds.least() == Double.POSITIVE_INFINITY) {
      return List.of();
    }
    double[] planAtLeast = bounds.costsWith();
    List<Rival> rivals = new ArrayList<>();
    for (int i = 0; i < planAtLeast.length; i++) {
      Operator operator = problem.operators().get(i);
      if (planAtLeast[i] <= cost + ROUNDING && isRival(operator)) {
        rivals.add(new Rival(isPossibleNow(operator), planAtLeast[i], price(operator)));
      }
    }
    return rivals.stream()
        .sorted(
            Comparator.comparing(Rival::isPossibleNow)
                .reversed()
                .thenComparingDouble(Rival::planAtLeast))
        .map(Rival::price)
        .toList();
  }

  private boolean isRival(Operator operator) {
    return !operator.price().exact()
        && !taken.contains(operator.key())
        && (isPossibleNow(operator)
            || deeds.contains(Deed.of(operator.feature().type(), operator.bindings())));
  }

  private boolean isPossibleNow(Operator operator) {
    return Successors.isApplicable(operator, problem.initial());
  }

  private OpenPrice price(Operator operator) {
    return new OpenPrice(
        operator.key(),
        operator.feature().type(),
        operator.price().cost(problem.initial().numbers()),
        operator.price().seconds(problem.initial().numbers()));
  }
}
