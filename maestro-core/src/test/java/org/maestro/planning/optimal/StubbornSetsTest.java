package org.maestro.planning.optimal;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.statistics.Statistics;
import org.maestro.planning.Everything;
import org.maestro.planning.ExhaustiveSearch;
import org.maestro.planning.OptimalityPropertyTest;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.problem.GroundProblem;

/** What stubborn sets leave out is never what the cheapest plan needs. */
class StubbornSetsTest {
  private static final int MOST_STATES = 5_000;

  @Property(tries = 200)
  void arbitraryFeatures(@ForAll Random random) {
    check(Everything.ground(OptimalityPropertyTest.puzzleTask(random)));
  }

  @Property(tries = 30)
  void homesLikeBobs(@ForAll Random random) {
    check(new Grounder(OptimalityPropertyTest.homeTask(random)).ground());
  }

  private static void check(GroundProblem problem) {
    OptionalDouble cheapest = ExhaustiveSearch.cheapest(problem, MOST_STATES);
    boolean isTooLarge = cheapest.isPresent() && Double.isNaN(cheapest.getAsDouble());
    Statistics.label("small enough to try everything")
        .collect(!isTooLarge)
        .coverage(coverage -> coverage.check(true).percentage(share -> share >= 50));
    if (isTooLarge) {
      return;
    }
    StubbornSets sets = new StubbornSets(problem);

    OptionalDouble among =
        ExhaustiveSearch.cheapest(
            problem,
            MOST_STATES,
            state -> sets.of(state).stream().mapToObj(problem.operators()::get).toList());

    assertThat(among.isPresent()).isEqualTo(cheapest.isPresent());
    cheapest.ifPresent(cost -> assertThat(Math.abs(among.getAsDouble() - cost)).isLessThan(1e-6));
  }
}
