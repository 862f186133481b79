package org.maestro.planning.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.PriorityQueue;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.LongRange;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.search.Solution.Verdict;

/** What the planner says of small random tasks is what exhaustive search says. */
class RandomTasksTest {
  private static final long MEMORY = 200_000_000;

  @Property(tries = 700)
  void costsWhatExhaustiveSearchSays(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
    GroundTask task = task(new Random(seed), seed % 3 == 0);
    OptionalLong least = leastCost(task);
    Solution solution =
        new AnytimePlanner(task, MEMORY, line -> {}).solve(GroundingBudget.endless());
    if (least.isEmpty()) {
      assertThat(solution.verdict()).isEqualTo(Verdict.UNSOLVABLE);
    } else {
      assertThat(solution.verdict()).isEqualTo(Verdict.OPTIMAL);
      assertThat(solution.cost()).isEqualTo(least.getAsLong());
      assertThat(solution.lowerBound()).isEqualTo(least.getAsLong());
      assertThat(costWhenRun(task, solution.operators())).isEqualTo(solution.cost());
    }
  }

  @Property(tries = 300)
  void firstPlansHoldAndBoundsAreNeverAboveTheCheapest(
      @ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
    GroundTask task = task(new Random(seed), true);
    OptionalLong least = leastCost(task);
    SearchTask search = new SearchTask(task, task.operators(), GroundingBudget.endless());
    long bound =
        new LandmarkCuts(search, search.cost, GroundingBudget.endless()).estimate(search.initial);
    assertThat(bound).isLessThanOrEqualTo(least.orElse(LandmarkCuts.INFINITE));
    Solution first = new AnytimePlanner(task, MEMORY, line -> {}).first(GroundingBudget.endless());
    assertThat(first.hasPlan()).isEqualTo(least.isPresent());
    if (first.hasPlan()) {
      assertThat(costWhenRun(task, first.operators())).isEqualTo(first.cost());
    }
  }

  @Property(tries = 200)
  void settlesSumsOfLampsAtLeastCost(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
    GroundTask task = lamps(new Random(seed));
    OptionalLong least = leastCost(task);
    Solution solution =
        new AnytimePlanner(task, MEMORY, line -> {}).solve(GroundingBudget.endless());
    assertThat(solution.hasPlan()).isEqualTo(least.isPresent());
    if (least.isPresent()) {
      assertThat(solution.verdict()).isEqualTo(Verdict.OPTIMAL);
      assertThat(solution.cost()).isEqualTo(least.getAsLong());
      assertThat(costWhenRun(task, solution.operators())).isEqualTo(least.getAsLong());
    }
  }

  /**
   * Lamps that are switched and cancel what is known; measuring; looks that need what is known and
   * light in intervals, of which sometimes none lies in the other.
   */
  static GroundTask lamps(Random random) {
    int lamps = 2 + random.nextInt(5);
    int known = 2 * lamps;
    int looks = 1 + random.nextInt(2);
    List<GroundOperator> operators = new ArrayList<>();
    int[] none = {};
    for (int lamp = 0; lamp < lamps; lamp++) {
      int gain = 1 + random.nextInt(9);
      for (int to = 0; to < 2; to++) {
        int from = 2 * lamp + 1 - to;
        operators.add(
            new GroundOperator(
                0,
                new int[] {operators.size()},
                new int[] {from},
                new int[] {2 * lamp + to},
                from < known ? new int[] {from, known} : none,
                none,
                new int[] {0},
                new long[] {to == 1 ? gain : -gain},
                random.nextInt(9)));
      }
    }
    operators.add(
        new GroundOperator(
            0,
            new int[] {operators.size()},
            none,
            new int[] {known},
            none,
            none,
            none,
            new long[0],
            random.nextInt(3)));
    List<GroundTask.Bound> bounds = new ArrayList<>();
    for (int look = 0; look < looks; look++) {
      long least = random.nextInt(15);
      bounds.add(new GroundTask.Bound(0, least, Long.MAX_VALUE));
      bounds.add(new GroundTask.Bound(0, Long.MIN_VALUE, least + random.nextInt(10)));
      operators.add(
          new GroundOperator(
              0,
              new int[] {operators.size()},
              new int[] {known},
              new int[] {known + 1 + look},
              none,
              new int[] {2 * look, 2 * look + 1},
              none,
              new long[0],
              random.nextInt(3)));
    }
    BitSet initial = new BitSet();
    for (int lamp = 0; lamp < lamps; lamp++) {
      initial.set(2 * lamp + random.nextInt(2));
    }
    initial.set(known, random.nextBoolean());
    return new GroundTask(
        known + 1 + looks,
        new long[] {random.nextInt(10)},
        bounds,
        operators,
        initial.stream().toArray(),
        IntStream.range(known + 1, known + 1 + looks).toArray(),
        none,
        BigDecimal.ONE,
        false,
        new Numbers());
  }

  /** Loosely coupled variables, so that there are leaves; some operators look at others. */
  static GroundTask task(Random random, boolean withSums) {
    int variables = 2 + random.nextInt(4);
    List<int[]> values = new ArrayList<>();
    int facts = 0;
    for (int v = 0; v < variables; v++) {
      int size = 2 + random.nextInt(3);
      int first = facts;
      values.add(IntStream.range(first, first + size).toArray());
      facts += size;
    }
    int sums = withSums ? 1 + random.nextInt(2) : 0;
    List<GroundTask.Bound> bounds = new ArrayList<>();
    for (int b = 0; b < 2 * sums; b++) {
      long least = random.nextInt(5) - 1;
      bounds.add(
          new GroundTask.Bound(
              b % sums,
              random.nextInt(4) == 0 ? Long.MIN_VALUE : least,
              random.nextInt(3) == 0 ? least + random.nextInt(3) : Long.MAX_VALUE));
    }
    List<GroundOperator> operators = new ArrayList<>();
    int count = 4 + random.nextInt(12);
    for (int o = 0; o < count; o++) {
      BitSet needed = new BitSet();
      BitSet added = new BitSet();
      BitSet deleted = new BitSet();
      int changed = random.nextInt(8) == 0 ? 2 : 1;
      for (int c = 0; c < changed; c++) {
        int[] variable = values.get(random.nextInt(variables));
        int from = variable[random.nextInt(variable.length)];
        int to = variable[random.nextInt(variable.length)];
        if (random.nextInt(10) > 0) {
          needed.set(from);
        }
        deleted.set(from);
        added.set(to);
      }
      for (int c = random.nextInt(3); c > 0; c--) {
        int[] variable = values.get(random.nextInt(variables));
        needed.set(variable[random.nextInt(variable.length)]);
      }
      deleted.andNot(added);
      int[] some = {};
      if (sums > 0 && random.nextInt(4) == 0) {
        some = new int[] {random.nextInt(bounds.size())};
      }
      boolean changes = sums > 0 && random.nextInt(2) == 0;
      // A fact of its own lets each change of a sum happen once, so that there are few states.
      int once = facts + o;
      if (changes) {
        needed.set(once);
        deleted.set(once);
      }
      operators.add(
          new GroundOperator(
              0,
              new int[] {o},
              needed.stream().toArray(),
              added.stream().toArray(),
              deleted.stream().toArray(),
              some,
              changes ? new int[] {random.nextInt(sums)} : new int[0],
              changes ? new long[] {random.nextInt(6) - 2} : new long[0],
              random.nextInt(5)));
    }
    BitSet initial = new BitSet();
    initial.set(facts, facts + count);
    BitSet goal = new BitSet();
    for (int[] variable : values) {
      initial.set(variable[0]);
      if (random.nextBoolean()) {
        goal.set(variable[random.nextInt(variable.length)]);
      }
    }
    return new GroundTask(
        facts + count,
        new long[sums],
        bounds,
        operators,
        initial.stream().toArray(),
        goal.stream().toArray(),
        sums > 0 && random.nextBoolean() ? new int[] {0} : new int[0],
        BigDecimal.ONE,
        false,
        new Numbers());
  }

  private record Numbers() implements GroundTask.Names {
    @Override
    public String fact(int fact) {
      return Integer.toString(fact);
    }

    @Override
    public String operator(GroundOperator operator) {
      return "(" + operator.arguments()[0] + ")";
    }
  }

  private record State(BitSet facts, List<Long> sums) {}

  private record Entry(long cost, State state) {}

  private static State initial(GroundTask task) {
    BitSet facts = new BitSet();
    IntStream.of(task.initial()).forEach(facts::set);
    return new State(facts, LongStream.of(task.sums()).boxed().toList());
  }

  private static boolean holds(GroundTask task, State state, int[] facts, int[] bounds) {
    return IntStream.of(facts).allMatch(state.facts()::get)
        && IntStream.of(bounds)
            .mapToObj(task.bounds()::get)
            .allMatch(bound -> bound.holds(state.sums().get(bound.sum())));
  }

  private static State after(State state, GroundOperator operator) {
    BitSet facts = (BitSet) state.facts().clone();
    IntStream.of(operator.deleted()).forEach(facts::clear);
    IntStream.of(operator.added()).forEach(facts::set);
    List<Long> sums = new ArrayList<>(state.sums());
    for (int i = 0; i < operator.changes().length; i++) {
      int sum = operator.changedSums()[i];
      sums.set(sum, sums.get(sum) + operator.changes()[i]);
    }
    return new State(facts, sums);
  }

  static OptionalLong leastCost(GroundTask task) {
    Map<State, Long> costs = new HashMap<>();
    PriorityQueue<Entry> queue = new PriorityQueue<>((a, b) -> Long.compare(a.cost(), b.cost()));
    costs.put(initial(task), 0L);
    queue.add(new Entry(0, initial(task)));
    while (!queue.isEmpty()) {
      Entry entry = queue.remove();
      if (entry.cost() > costs.get(entry.state())) {
        continue;
      }
      if (holds(task, entry.state(), task.goal(), task.goalBounds())) {
        return OptionalLong.of(entry.cost());
      }
      for (GroundOperator operator : task.operators()) {
        if (holds(task, entry.state(), operator.needed(), operator.bounds())) {
          State next = after(entry.state(), operator);
          long cost = entry.cost() + operator.cost();
          if (cost < costs.getOrDefault(next, Long.MAX_VALUE)) {
            costs.put(next, cost);
            queue.add(new Entry(cost, next));
          }
        }
      }
    }
    return OptionalLong.empty();
  }

  private static long costWhenRun(GroundTask task, List<GroundOperator> plan) {
    State state = initial(task);
    long cost = 0;
    for (GroundOperator step : plan) {
      // By its number, as a task may have been reduced before it was solved.
      GroundOperator operator =
          task.operators().stream()
              .filter(o -> o.arguments()[0] == step.arguments()[0])
              .findFirst()
              .orElseThrow();
      assertThat(holds(task, state, operator.needed(), operator.bounds())).isTrue();
      state = after(state, operator);
      cost += operator.cost();
    }
    assertThat(holds(task, state, task.goal(), task.goalBounds())).isTrue();
    return cost;
  }
}
