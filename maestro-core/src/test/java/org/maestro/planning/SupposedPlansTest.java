package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.maestro.planning.SearchHomes.SearchHome;
import org.maestro.planning.api.Effort;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.optimal.LandmarkCut;
import org.maestro.planning.optimal.OptimalSearch;
import org.maestro.planning.optimal.Pruning;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.PlanBuilder;
import org.maestro.planning.problem.Sought;
import org.maestro.planning.problem.Variable;
import org.maestro.planning.sensing.MostLikelyState;

/** What is proven with a small budget, against a search with a larger one. */
class SupposedPlansTest {
  private static final int HOMES = 12;

  /** Where there is no plan with all steps, there is none with a few. */
  private static final double NO_PLAN = 20;

  @Test
  void belowWhatTheBudgetLeavesOutAPlanStaysTheCheapest() {
    int kept = 0;
    for (int number = 1; number <= HOMES; number++) {
      int seed = number;
      SearchHome home = SearchHomes.home(new Random(seed), 3 + seed % 3, 1 + seed % 2);
      PlanningTask task = home.world().task(home.goal());
      Grounder grounder = new Grounder(task);
      GroundProblem whole = grounder.ground().placed();
      for (MostLikelyState supposed : suppositions(whole)) {
        GroundProblem all = pruned(supposed, whole);
        double cheapest = cheapest(all).map(plan -> cost(all, plan)).orElse(NO_PLAN);
        for (double budget : new double[] {0.6 * cheapest, cheapest, 1.4 * cheapest}) {
          Grounder.Grounded ground = grounder.ground(budget);
          GroundProblem few = pruned(supposed, ground.problem());
          SupposedPlans plans = new SupposedPlans();
          cheapest(few)
              .ifPresent(plan -> plans.keep(supposed, plan, cost(few, plan), ground.beyond()));
          Optional<List<Operator>> known = plans.of(supposed, all.placed());
          known.ifPresent(
              plan ->
                  assertThat(cost(all, plan))
                      .as("home %d", seed)
                      .isCloseTo(cheapest, within(1e-9)));
          kept += known.isPresent() ? 1 : 0;
        }
      }
    }
    assertThat(kept).isGreaterThan(HOMES);
  }

  /** Each thing in turn at each place and nowhere, the others where they are found first. */
  private static List<MostLikelyState> suppositions(GroundProblem whole) {
    List<Sought> all = Sought.of(whole);
    List<MostLikelyState> suppositions = new ArrayList<>();
    for (Sought one : all) {
      for (int place : one.values()) {
        suppositions.add(supposed(all, one, place));
      }
      suppositions.add(supposed(all, one, Variable.NONE));
    }
    return suppositions;
  }

  private static MostLikelyState supposed(List<Sought> all, Sought one, int place) {
    Map<Sought, Integer> places = new LinkedHashMap<>();
    all.forEach(sought -> places.put(sought, sought == one ? place : sought.values().get(0)));
    return new MostLikelyState(places);
  }

  private static GroundProblem pruned(MostLikelyState supposed, GroundProblem problem) {
    return Pruning.pruned(supposed.appliedTo(problem.placed())).problem();
  }

  private static Optional<List<Operator>> cheapest(GroundProblem problem) {
    Pruning.Pruned pruned = Pruning.pruned(problem);
    OptimalSearch search =
        new OptimalSearch(
            pruned.problem().placed(),
            new LandmarkCut(pruned.relaxed()),
            Effort.forBestPlan(20_000),
            Double.POSITIVE_INFINITY);
    return pruned.isSolvable() && search.run() instanceof OptimalSearch.Outcome.Found found
        ? Optional.of(found.operators())
        : Optional.empty();
  }

  private static double cost(GroundProblem problem, List<Operator> plan) {
    return PlanBuilder.plan(problem.placed(), plan).cost();
  }
}
