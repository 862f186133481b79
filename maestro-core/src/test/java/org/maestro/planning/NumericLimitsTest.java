package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningResult.Obstacle.Kind;

/** That nothing is called impossible, and no number a limit, that trying everything refutes. */
class NumericLimitsTest {
  private final OptimalPlanner planner = new OptimalPlanner(1_000);
  private int limits;
  private int found;

  @Test
  void noHomeRefutesALimit() {
    LongStream.range(0, 60).forEach(this::check);
    assertThat(limits).as("limits told").isGreaterThan(20);
  }

  @Test
  @Tag("full")
  void noneOfTwoThousandHomesRefutesALimit() {
    LongStream.range(0, 2_000).forEach(this::check);
    assertThat(limits).as("limits told").isGreaterThan(600);
    assertThat(found).as("numbers that are not called limits").isPositive();
  }

  private void check(long seed) {
    NumericHome home = new NumericHome(seed);
    PlanningResult result = planner.plan(home.task());
    NumericHome.Reached reached = home.reached();
    String told = "seed " + seed + ": " + home + result;
    if (result instanceof PlanningResult.Found) {
      assertThat(reached.any(home.goalOfTheHome()) || !reached.all()).as(told).isTrue();
    } else if (result instanceof PlanningResult.Impossible impossible) {
      assertThat(reached.any(home.goalOfTheHome())).as(told).isFalse();
      impossible.explanation().obstacles().forEach(obstacle -> check(obstacle, home, told));
    }
  }

  private void check(Obstacle obstacle, NumericHome home, String told) {
    if (obstacle.kind() != Kind.NUMBER) {
      return;
    }
    int quantity = Integer.parseInt(obstacle.condition().replaceAll(".*q(\\d).*", "$1"));
    boolean highest = obstacle.needed().startsWith(">");
    double possible = Double.parseDouble(obstacle.possible());
    double best = home.reached().extreme(quantity, highest);
    double bestWithAll = home.reachedWithAll().extreme(quantity, highest);
    String of = told + obstacle;
    switch (obstacle.extent()) {
      case LIMIT -> {
        limits++;
        assertThat(isNoBetter(bestWithAll, possible, highest))
            .as("%s: %s", of, bestWithAll)
            .isTrue();
        assertThat(home.reached().all() && best != possible).as("%s: %s", of, best).isFalse();
      }
      case LIMIT_NOW -> {
        limits++;
        assertThat(isNoBetter(best, possible, highest)).as("%s: %s", of, best).isTrue();
        assertThat(home.reached().all() && best != possible).as("%s: %s", of, best).isFalse();
      }
      case FOUND -> {
        found++;
        assertThat(home.reached().all() && !isNoBetter(possible, best, highest))
            .as("%s: %s", of, best)
            .isFalse();
      }
      case KNOWN -> assertThat(possible).as(of).isEqualTo(home.level(quantity));
    }
  }

  private static boolean isNoBetter(double one, double than, boolean highest) {
    return highest ? one <= than : one >= than;
  }
}
