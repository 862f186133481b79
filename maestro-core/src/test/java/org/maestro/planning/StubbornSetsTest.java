package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;

/** What stubborn sets leave out is never what the cheapest plan needs. */
class StubbornSetsTest {
  private static final int MOST_STATES = 5_000;

  @Property(tries = 200, shrinking = ShrinkingMode.OFF)
  void arbitraryFeatures(@ForAll long seed) {
    check(Everything.ground(OptimalityPropertyTest.puzzleTask(new Random(seed))));
  }

  @Property(tries = 30, shrinking = ShrinkingMode.OFF)
  void homesLikeBobs(@ForAll long seed) {
    check(new Grounder(OptimalityPropertyTest.homeTask(new Random(seed))).ground());
  }

  private static void check(GroundProblem problem) {
    OptionalDouble cheapest = ExhaustiveSearch.cheapest(problem, MOST_STATES);
    if (cheapest.isPresent() && Double.isNaN(cheapest.getAsDouble())) {
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
