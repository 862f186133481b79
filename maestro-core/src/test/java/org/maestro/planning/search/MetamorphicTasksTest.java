package org.maestro.planning.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.GroundingBudget;

/** What has to become of the cheapest plan's cost when a task is changed in known ways. */
class MetamorphicTasksTest {
  private static final long NO_PLAN = Long.MAX_VALUE;

  @Property(tries = 150)
  void costsFollowTheTask(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
    Random random = new Random(seed);
    GroundTask task = RandomTasksTest.task(random, seed % 3 == 0);
    long cost = cost(task);
    List<GroundOperator> operators = task.operators();
    List<GroundOperator> more = new ArrayList<>(operators);
    operators.forEach(o -> more.add(priced(o, o.cost() + 1 + random.nextInt(3))));
    assertThat(cost(task.withOperators(more))).isEqualTo(cost);
    List<GroundOperator> shuffled = new ArrayList<>(operators);
    Collections.shuffle(shuffled, random);
    assertThat(cost(task.withOperators(shuffled))).isEqualTo(cost);
    assertThat(
            cost(task.withOperators(operators.stream().map(o -> priced(o, 7 * o.cost())).toList())))
        .isEqualTo(cost == NO_PLAN ? NO_PLAN : 7 * cost);
    int one = random.nextInt(operators.size());
    List<GroundOperator> cheaper = new ArrayList<>(operators);
    cheaper.set(one, priced(operators.get(one), operators.get(one).cost() / 2));
    assertThat(cost(task.withOperators(cheaper))).isLessThanOrEqualTo(cost);
    List<GroundOperator> fewer = new ArrayList<>(operators);
    fewer.remove(one);
    assertThat(cost(task.withOperators(fewer))).isGreaterThanOrEqualTo(cost);
  }

  private static GroundOperator priced(GroundOperator o, long cost) {
    return new GroundOperator(
        o.schema(),
        Arrays.copyOf(o.arguments(), o.arguments().length),
        o.needed(),
        o.added(),
        o.deleted(),
        o.bounds(),
        o.changedSums(),
        o.changes(),
        cost);
  }

  private static long cost(GroundTask task) {
    Solution solution =
        new AnytimePlanner(task, 200_000_000, line -> {}).solve(GroundingBudget.endless());
    return solution.hasPlan() ? solution.cost() : NO_PLAN;
  }
}
