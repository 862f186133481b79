package org.maestro.planning.optimal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.statistics.Statistics;
import org.maestro.planning.Everything;
import org.maestro.planning.ExhaustiveSearch;
import org.maestro.planning.OptimalityPropertyTest;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.problem.Execution;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Successors;

/** What one of several can do alone is a plan, and claims to be no better than it is. */
class PlansOfOneTest {
  private static final int MOST_STATES = 2_000;
  private static final double ROUNDING = 1e-6;

  @Property(tries = 150)
  void arbitraryFeatures(@ForAll Random random) {
    PlanningTask task = withTwins(OptimalityPropertyTest.puzzleTask(random));
    GroundProblem problem = Everything.ground(task);
    Optional<PlanningResult.Found> found =
        new PlansOfOne(problem, task.features(), MOST_STATES).cheapest(Double.POSITIVE_INFINITY);
    Statistics.label("one can do it").collect(found.isPresent());
    if (found.isEmpty()) {
      return;
    }
    double cost = found.get().plan().cost();
    List<StepKey> steps = found.get().plan().steps().stream().map(Step::key).toList();

    List<Operator> operators =
        Execution.operators(problem.operators(), problem.initial(), steps).orElseThrow();

    State state = problem.initial();
    for (Operator operator : operators) {
      state = Successors.after(operator, state);
    }
    assertThat(problem.goal().condition().holds(state)).isTrue();
    assertThat(found.get().atLeast()).hasValue(cost);
    assertThat(found.get().contenders()).containsAll(found.get().plan().members());
    OptionalDouble cheapest = ExhaustiveSearch.cheapest(problem, MOST_STATES);
    if (cheapest.isPresent() && !Double.isNaN(cheapest.getAsDouble())) {
      assertThat(cost).isGreaterThanOrEqualTo(cheapest.getAsDouble() - ROUNDING);
    }
  }

  /** Somebody else can do all that anybody can. */
  private static PlanningTask withTwins(PlanningTask task) {
    List<PricedFeature> features = new ArrayList<>(task.features());
    for (PricedFeature feature : task.features()) {
      features.add(
          new PricedFeature(
              feature.member() + "-twin", feature.type(), feature.price(), feature.exact()));
    }
    return new PlanningTask(task.vocabulary(), task.facts(), features, task.goal(), task.barred());
  }
}
