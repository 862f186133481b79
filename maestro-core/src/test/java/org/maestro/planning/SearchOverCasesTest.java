package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.statistics.Statistics;
import org.junit.jupiter.api.Test;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.optimal.OptimalSearch.Outcome;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.PlanBuilder;

/**
 * The search over cases finds plans of the cost that exhaustive search finds, none where there is
 * none, and the same each time.
 */
class SearchOverCasesTest {
  @Property(tries = 100)
  void homesLikeBobs(@ForAll Random random) {
    check(new Grounder(OptimalityPropertyTest.homeTask(random)).ground());
  }

  @Property(tries = 400)
  void arbitraryFeatures(@ForAll Random random) {
    check(Everything.ground(OptimalityPropertyTest.puzzleTask(random)));
  }

  @Test
  void bobsCupInTheDark() {
    PlanningTask task = BobsHome.dark().task("(nextTo Cup Bob)");
    Outcome found = searchOf(new Grounder(task).ground()).run(Double.POSITIVE_INFINITY);
    GroundProblem problem = new Grounder(task).ground();
    Outcome again = searchOf(problem).run(Double.POSITIVE_INFINITY);

    assertThat(found).isInstanceOf(Outcome.Found.class);
    assertThat(keys(again)).isEqualTo(keys(found));
    double cost = PlanBuilder.plan(problem.placed(), ((Outcome.Found) again).operators()).cost();
    assertThat(searchOf(problem).run(cost)).isInstanceOf(Outcome.Found.class);
    assertThat(searchOf(problem).run(cost - 0.01))
        .isInstanceOfSatisfying(
            Outcome.TooDear.class,
            dear -> assertThat(dear.atLeast()).isCloseTo(cost, within(1e-6)));
  }

  private static SearchOverCases searchOf(GroundProblem problem) {
    return new SearchOverCases(problem, OptimalPlanner.DEFAULT_MOST_STATES);
  }

  private static List<String> keys(Outcome outcome) {
    return ((Outcome.Found) outcome).operators().stream().map(o -> o.key().toString()).toList();
  }

  private static void check(GroundProblem problem) {
    OptionalDouble expected = ExhaustiveSearch.cheapest(problem, 20_000);
    boolean isJudged = expected.isEmpty() || !Double.isNaN(expected.getAsDouble());
    Outcome outcome = searchOf(problem).run(Double.POSITIVE_INFINITY);
    boolean isAnswered = !(outcome instanceof Outcome.BoundReached);
    Statistics.label("judged and answered")
        .collect(isJudged && isAnswered)
        .coverage(coverage -> coverage.check(true).percentage(share -> share >= 80));
    if (!isJudged || !isAnswered) {
      return;
    }
    if (expected.isEmpty()) {
      assertThat(outcome).isInstanceOf(Outcome.Exhausted.class);
      return;
    }
    assertThat(outcome).isInstanceOf(Outcome.Found.class);
    List<Operator> plan = ((Outcome.Found) outcome).operators();
    assertThat(PlanBuilder.plan(problem.placed(), plan).cost())
        .isCloseTo(expected.getAsDouble(), within(1e-6));
  }
}
