package org.maestro.planning.optimal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.statistics.Statistics;
import org.maestro.planning.Everything;
import org.maestro.planning.ExhaustiveSearch;
import org.maestro.planning.OptimalityPropertyTest;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Successors;

/** Cuts that are handed on to the state after a step never claim too much, and lose little. */
class LandmarkCutTest {
  private static final int MOST_STATES = 2_000;
  private static final int STEPS = 3;
  private static final double ROUNDING = 1e-6;

  /** Ties are cut otherwise when the costs are. */
  private static final double LEAST_SHARE = 0.7;

  @Property(tries = 150)
  void arbitraryFeatures(@ForAll Random random) {
    walk(Everything.ground(OptimalityPropertyTest.puzzleTask(random)), random);
  }

  @Property(tries = 20)
  void homesLikeBobs(@ForAll Random random) {
    walk(new Grounder(OptimalityPropertyTest.homeTask(random)).ground(), random);
  }

  @Property(tries = 150)
  void cutsOfGrains(@ForAll Random random) {
    GroundProblem problem = Everything.ground(OptimalityPropertyTest.puzzleTask(random));
    walk(problem, new LandmarkCut(new RelaxedProblem(problem), 0), random);
  }

  @Property(tries = 150)
  void littleIsLeftOutOfGrains(@ForAll Random random) {
    GroundProblem problem = Everything.ground(OptimalityPropertyTest.puzzleTask(random));
    RelaxedProblem relaxed = new RelaxedProblem(problem);
    LandmarkCut ofGrains = new LandmarkCut(relaxed, 0);
    double all = new LandmarkCut(relaxed).estimate(problem.initial());
    double most = ofGrains.estimate(problem.initial());
    Statistics.label("there is a plan").collect(Double.isFinite(all));
    assertThat(Double.isFinite(most)).isEqualTo(Double.isFinite(all));
    if (Double.isFinite(all)) {
      assertThat(most).isGreaterThanOrEqualTo(LEAST_SHARE * all);
    }
  }

  private static void walk(GroundProblem problem, Random random) {
    walk(problem, new LandmarkCut(new RelaxedProblem(problem)), random);
  }

  private static void walk(GroundProblem problem, LandmarkCut heuristic, Random random) {
    State state = problem.initial();
    double estimate = heuristic.estimate(state);
    for (int step = 0; step < STEPS && Double.isFinite(estimate); step++) {
      State here = state;
      int[] applicable =
          IntStream.range(0, problem.operators().size())
              .filter(i -> Successors.isApplicable(problem.operators().get(i), here))
              .toArray();
      if (applicable.length == 0) {
        return;
      }
      int taken = applicable[random.nextInt(applicable.length)];
      Operator operator = problem.operators().get(taken);
      List<LandmarkCut.Cut> handedOn = heuristic.after(taken, heuristic.cuts());
      double known = handedOn.stream().mapToDouble(LandmarkCut.Cut::cost).sum();
      state = Successors.after(operator, state);

      estimate = heuristic.estimate(state, handedOn);

      Statistics.label("cuts are handed on").collect(!handedOn.isEmpty());
      assertThat(estimate).isGreaterThanOrEqualTo(known - ROUNDING);
      OptionalDouble cheapest = ExhaustiveSearch.cheapest(from(state, problem), MOST_STATES);
      if (cheapest.isPresent() && !Double.isNaN(cheapest.getAsDouble())) {
        assertThat(estimate).isLessThanOrEqualTo(cheapest.getAsDouble() + ROUNDING);
      }
    }
  }

  private static GroundProblem from(State state, GroundProblem problem) {
    return new GroundProblem(
        problem.operators(), problem.goal(), problem.variables(), problem.numbers(), state);
  }
}
