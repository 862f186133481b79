package org.maestro.planning.sensing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Expected costs of searches, against what all orders cost. */
class SearchOrderTest {

  private static SearchOrder.Cost cost(double look, double rest) {
    return new SearchOrder.Cost(look, rest);
  }

  private static SearchOrder independent(double[] chance, SearchOrder.Cost... boxes) {
    SearchOrder.Cost[][] next = new SearchOrder.Cost[boxes.length][];
    Arrays.fill(next, boxes);
    return new SearchOrder(chance, boxes, next);
  }

  private static int best(SearchOrder order, int boxes) {
    int best = 0;
    for (int i = 1; i < boxes; i++) {
      best = order.expectedCost(i) < order.expectedCost(best) ? i : best;
    }
    return best;
  }

  @Test
  void chanceOverCostDecidesAmongIndependentBoxes() {
    SearchOrder order =
        independent(new double[] {0.5, 0.3, 0.2}, cost(10, 3), cost(2, 3), cost(5, 3));
    assertThat(best(order, 3)).isEqualTo(1);
    assertThat(order.expectedCost(1)).isCloseTo(2 + 0.7 * 10 + 0.2 * 5 + 3, within(1e-9));
  }

  @Test
  void whatTheRestCostsDoesNotChangeTheOrder() {
    assertThat(best(independent(new double[] {0.6, 0.4}, cost(2, 100), cost(2, 0)), 2)).isZero();
  }

  @Test
  void aLookOnTheWayIsTakenAlong() {
    SearchOrder.Cost[][] next = {{cost(5, 0), cost(5, 0)}, {cost(5, 0), cost(10, 0)}};
    SearchOrder order =
        new SearchOrder(
            new double[] {0.3, 0.7}, new SearchOrder.Cost[] {cost(5, 0), cost(10, 0)}, next);
    assertThat(best(order, 2)).isZero();
  }

  @Test
  void manyBoxesAreTakenByChanceOverCost() {
    double[] chance = new double[14];
    SearchOrder.Cost[] boxes = new SearchOrder.Cost[14];
    for (int i = 0; i < boxes.length; i++) {
      chance[i] = (i + 1) / 105.0;
      boxes[i] = cost(1, 2);
    }
    SearchOrder order = independent(chance, boxes);
    assertThat(best(order, boxes.length)).isEqualTo(13);
    double expected = 2;
    double left = 1;
    for (int i = 13; i >= 0; i--) {
      expected += left;
      left -= chance[i];
    }
    assertThat(order.expectedCost(13)).isCloseTo(expected, within(1e-9));
  }

  @Test
  void boxesThatDoNotDependOnEachOtherCostTheSameInOneOrder() {
    Random random = new Random(7);
    for (int trial = 0; trial < 100; trial++) {
      int size = 2 + random.nextInt(15);
      double[] chance = random.doubles(size, 0.05, 1).toArray();
      double sum = Arrays.stream(chance).sum();
      SearchOrder.Cost[] boxes = new SearchOrder.Cost[size];
      for (int i = 0; i < size; i++) {
        chance[i] /= sum;
        boxes[i] = cost(random.nextInt(9), 10 * random.nextDouble());
      }
      SearchOrder inOneOrder = new SearchOrder(chance, boxes);
      SearchOrder weighed = independent(chance, boxes);
      for (int box = 0; box < size; box++) {
        assertThat(inOneOrder.expectedCost(box)).isCloseTo(weighed.expectedCost(box), within(1e-9));
      }
    }
  }

  @Test
  void noOrderIsBetterThanTheOneFound() {
    Random random = new Random(4);
    for (int trial = 0; trial < 200; trial++) {
      int size = 2 + random.nextInt(4);
      double[] chance = random.doubles(size, 0.05, 1).toArray();
      double sum = Arrays.stream(chance).sum();
      SearchOrder.Cost[] first = new SearchOrder.Cost[size];
      SearchOrder.Cost[][] next = new SearchOrder.Cost[size][size];
      for (int i = 0; i < size; i++) {
        chance[i] /= sum;
        first[i] = cost(random.nextInt(9), 10 * random.nextDouble());
        for (int j = 0; j < size; j++) {
          next[i][j] = cost(random.nextInt(9), 10 * random.nextDouble());
        }
      }
      SearchOrder order = new SearchOrder(chance, first, next);
      double least = Double.POSITIVE_INFINITY;
      for (List<Integer> turn : orders(size)) {
        least = Math.min(least, expected(turn, chance, first, next));
      }
      assertThat(order.expectedCost(best(order, size))).isCloseTo(least, within(1e-9));
    }
  }

  static List<List<Integer>> orders(int size) {
    List<List<Integer>> orders = new ArrayList<>();
    orders.add(List.of());
    for (int step = 0; step < size; step++) {
      List<List<Integer>> longer = new ArrayList<>();
      for (List<Integer> order : orders) {
        for (int next = 0; next < size; next++) {
          if (!order.contains(next)) {
            List<Integer> extended = new ArrayList<>(order);
            extended.add(next);
            longer.add(List.copyOf(extended));
          }
        }
      }
      orders = longer;
    }
    return orders;
  }

  private static double expected(
      List<Integer> turn, double[] chance, SearchOrder.Cost[] first, SearchOrder.Cost[][] next) {
    double total = 0;
    double left = 1;
    for (int i = 0; i < turn.size(); i++) {
      int box = turn.get(i);
      SearchOrder.Cost cost = i == 0 ? first[box] : next[turn.get(i - 1)][box];
      total += left * cost.look() + chance[box] * cost.rest();
      left -= chance[box];
    }
    return total;
  }
}
