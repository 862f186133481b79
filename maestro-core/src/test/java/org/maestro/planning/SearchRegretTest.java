package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.fixtures.Share;
import org.maestro.planning.SearchHomes.SearchHome;

/**
 * How much more searches cost than in the best of all orders, which is found by trying them all:
 * both in the mean over where the things may be, both carried out to the end with all plans made on
 * the way.
 */
class SearchRegretTest {
  private static final double MOST_IN_THE_MEAN = 1.15;

  @Test
  void searchesCostLittleMoreThanInTheBestOrder() {
    measure(LongStream.rangeClosed(1, 20), 4);
  }

  @Test
  @Tag("full")
  void neitherInManyHomesAndLargerOnes() {
    measure(Share.of(LongStream.rangeClosed(1, 240)), 5);
  }

  @Test
  void amongManyPlacesTheyCostLessThanByOptimism() {
    compareWithOptimism(LongStream.rangeClosed(1, 3));
  }

  @Test
  @Tag("full")
  void amongManyPlacesTheyDoInManyHomes() {
    compareWithOptimism(Share.of(LongStream.rangeClosed(4, 30)));
  }

  /** With so many places not all orders can be tried; optimism alone is the measure then. */
  private static void compareWithOptimism(LongStream seeds) {
    double sum = 0;
    double optimists = 0;
    for (long seed : seeds.toArray()) {
      Random random = new Random(seed);
      SearchHome home = SearchHomes.home(random, 9 + random.nextInt(4), 1);
      SearchPolicy policy = new SearchPolicy(home, trueLux(home, random));
      Optional<Double> ours = policy.ofPlanner();
      if (ours.isPresent()) {
        sum += ours.get();
        optimists += policy.ofOptimist();
      }
    }
    System.out.printf("search among many places: %.3f of by optimism alone%n", sum / optimists);
    assertThat(sum / optimists).isLessThan(1);
  }

  private static void measure(LongStream seeds, int mostZones) {
    double sum = 0;
    double sumOfOptimist = 0;
    double worst = 1;
    long worstSeed = 0;
    int measured = 0;
    for (long seed : seeds.toArray()) {
      Random random = new Random(seed);
      int sought = random.nextInt(4) == 0 ? 2 : 1;
      int zones = sought == 2 ? 2 : 2 + random.nextInt(mostZones - 1);
      SearchHome home = SearchHomes.home(random, zones, sought);
      SearchPolicy policy = new SearchPolicy(home, trueLux(home, random));
      Optional<Double> ours = policy.ofPlanner();
      if (ours.isEmpty() || ours.get() == 0) {
        continue;
      }
      double best = policy.ofBestOrder();
      double regret = ours.get() / best;
      assertThat(regret).as("seed %d", seed).isBetween(0.0, 1000.0);
      measured++;
      sum += regret;
      sumOfOptimist += policy.ofOptimist() / best;
      if (regret > worst) {
        worst = regret;
        worstSeed = seed;
      }
    }
    System.out.printf(
        "search regret over %d homes: mean %.3f, worst %.3f (seed %d); by optimism alone %.3f%n",
        measured, sum / measured, worst, worstSeed, sumOfOptimist / measured);
    assertThat(sum / measured).isLessThanOrEqualTo(MOST_IN_THE_MEAN);
  }

  private static Map<String, Double> trueLux(SearchHome home, Random random) {
    Map<String, Double> lux = new HashMap<>();
    home.zones().forEach(zone -> lux.put(zone, random.nextBoolean() ? 90.0 : 20.0));
    return lux;
  }
}
