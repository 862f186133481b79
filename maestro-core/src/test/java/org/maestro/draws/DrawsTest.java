package org.maestro.draws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Shrinkable;
import org.junit.jupiter.api.Test;

/** Chance that can be shrunk is chance still. */
class DrawsTest {

  @Property(tries = 200)
  void numbersStayWithinTheirBounds(@ForAll Random random) {
    assertThat(random).isInstanceOf(Draws.class);
    assertThat(random.nextInt(7)).isBetween(0, 6);
    assertThat(random.nextDouble()).isBetween(0.0, 1.0);
    assertThat(random.nextInt(3, 5)).isBetween(3, 4);
  }

  @Test
  void theSameDrawsAreTheSameCaseAndNoneIsTheSimplest() {
    List<Integer> draws = List.of(123_456_789, -42, 1 << 30);

    assertThat(new Draws(draws).ints(3, 0, 100).toArray())
        .isEqualTo(new Draws(draws).ints(3, 0, 100).toArray());
    assertThat(new Draws(List.of()).ints(5, 0, 100).toArray()).containsOnly(0);
  }

  /** Some loops wait for a number that fits. */
  @Test
  void whoDrawsOnAndOnIsNotGivenZerosForEver() {
    Random random = new Draws(List.of());
    AtomicInteger draws = new AtomicInteger();
    while (random.nextInt(2) == 0) {
      draws.incrementAndGet();
    }
    assertThat(draws.get()).isPositive();
  }

  /** A case that needs one large draw only shrinks to a short list. */
  @Example
  void aCaseShrinks() {
    Shrinkable<List<Integer>> found =
        Arbitraries.integers().list().ofMaxSize(100).generator(100).stream(new Random(1))
            .filter(list -> fails(list.value()))
            .findFirst()
            .orElseThrow();
    Shrinkable<List<Integer>> smallest = found;
    for (boolean smaller = true; smaller; ) {
      Shrinkable<List<Integer>> before = smallest;
      smallest =
          before
              .shrink()
              .filter(list -> fails(list.value()))
              .filter(list -> list.distance().compareTo(before.distance()) < 0)
              .findFirst()
              .orElse(before);
      smaller = smallest != before;
    }
    assertThat(smallest.value()).hasSizeLessThan(found.value().size());
    assertThat(Collections.frequency(smallest.value(), 0)).isEqualTo(smallest.value().size() - 1);
  }

  private static boolean fails(List<Integer> draws) {
    return draws.size() > 3 && new Draws(draws).nextInt(100) > 50;
  }
}
