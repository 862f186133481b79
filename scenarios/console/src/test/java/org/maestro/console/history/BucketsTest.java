package org.maestro.console.history;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

/** However few parts a span is drawn with, no peak is lost and nothing is made up. */
class BucketsTest {
  private static final long FROM = 1_000;

  @Property(tries = 300)
  void eachMomentIsWithinWhatIsDrawnOfIt(@ForAll Random random) {
    List<Sample> samples = samples(random);
    long to = FROM + 1 + random.nextInt(2_000);
    long until = samples.get(samples.size() - 1).at() + random.nextInt(300);
    int number = 1 + random.nextInt(40);

    Buckets buckets = Buckets.of(samples, FROM, to, until, number);

    double length = (to - FROM) / (double) number;
    boolean[] known = new boolean[number];
    for (long at = FROM; at < to; at++) {
      int i = Math.min(number - 1, (int) ((at - FROM) / length));
      Sample then = at < until ? at(samples, at) : Sample.unknown(at);
      if (then.isKnown()) {
        known[i] = true;
        assertThat(buckets.isKnown(i)).as("%d in %d of %s", at, i, samples).isTrue();
        assertThat(buckets.low(i)).isLessThanOrEqualTo(then.low());
        assertThat(buckets.high(i)).isGreaterThanOrEqualTo(then.high());
      }
    }
    for (int i = 0; i < number; i++) {
      if (buckets.isKnown(i)) {
        assertThat(buckets.mean(i)).isBetween(buckets.low(i), buckets.high(i));
      }
    }
    assertThat(peak(samples, to)).isLessThanOrEqualTo(highest(buckets));
  }

  private static List<Sample> samples(Random random) {
    List<Sample> samples = new ArrayList<>();
    long at = FROM - random.nextInt(500);
    for (int i = 0; i <= random.nextInt(30); i++) {
      double value = random.nextInt(1_000) / 10.0;
      samples.add(
          random.nextInt(5) == 0
              ? Sample.unknown(at)
              : new Sample(at, value - random.nextInt(3), value, value + random.nextInt(3)));
      at += random.nextInt(200);
    }
    return samples;
  }

  /** The last of those that came up to then. */
  private static Sample at(List<Sample> samples, long at) {
    Sample last = Sample.unknown(at);
    for (Sample sample : samples) {
      last = sample.at() <= at ? sample : last;
    }
    return last;
  }

  /** Whatever was so for no time at all, too. */
  private static double peak(List<Sample> samples, long to) {
    return samples.stream()
        .filter(sample -> sample.isKnown() && sample.at() >= FROM && sample.at() < to)
        .mapToDouble(Sample::high)
        .max()
        .orElse(Double.NEGATIVE_INFINITY);
  }

  private static double highest(Buckets buckets) {
    double highest = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < buckets.number(); i++) {
      highest = Math.max(highest, buckets.high(i));
    }
    return highest;
  }

  @Test
  void whatIsNotKnownIsAGap() {
    List<Sample> samples = List.of(Sample.of(500, 80), Sample.unknown(1_200), Sample.of(1_350, 20));

    Buckets buckets = Buckets.of(samples, FROM, 2_000, 1_600, 10);

    assertThat(buckets.mean(0)).as("it was so before").isEqualTo(80);
    assertThat(buckets.isKnown(2)).isFalse();
    assertThat(buckets.isKnown(3)).as("for a half of it").isTrue();
    assertThat(buckets.mean(3)).isEqualTo(20, within(1e-9));
    assertThat(buckets.isKnown(5)).isTrue();
    assertThat(buckets.isKnown(6)).as("after the end").isFalse();
  }
}
