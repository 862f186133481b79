package org.maestro.rats.member;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import org.junit.jupiter.api.Test;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.time.SteppedClock;

class CallerClocksTest {
  private final CallerClocks clocks = new CallerClocks(new SteppedClock());

  private Optional<Duration> age(String clock, long sentMillis, long arrivedMillis) {
    Call call =
        new Call(
                "c1",
                Optional.of("rose"),
                Optional.empty(),
                "drive",
                Map.of(),
                Duration.ofSeconds(15),
                "cca",
                Optional.empty())
            .madeAt(new Call.Sent(clock, sentMillis));
    return clocks.age(call, Duration.ofMillis(arrivedMillis));
  }

  @Test
  void theFirstCallOfAClockTellsNothing() {
    assertThat(age("k1", 5_000_000, 100)).isEmpty();
    assertThat(age("k2", 7, 60_000)).isEmpty();
  }

  @Test
  void whatTakesLongerThanTheQuickestIsOld() {
    age("k1", 5_000_000, 100);
    assertThat(age("k1", 5_001_000, 1_100)).contains(Duration.ZERO);
    assertThat(age("k1", 5_002_000, 32_100).orElseThrow())
        .isBetween(Duration.ofMillis(29_900), Duration.ofMillis(30_000));
  }

  @Test
  void aQuickerOneIsTheMeasureFromThenOn() {
    age("k1", 0, 10_000);
    assertThat(age("k1", 20_000, 20_100)).contains(Duration.ZERO);
    assertThat(age("k1", 21_000, 31_000).orElseThrow())
        .isBetween(Duration.ofMillis(9_800), Duration.ofMillis(9_900));
  }

  /**
   * However the clocks stand to each other, and though they drift: nobody is called late falsely.
   */
  @Property(tries = 300)
  void noCallIsTakenForOlderThanItIs(
      @ForAll @LongRange(min = 0, max = 1_000_000_000_000L) long ahead,
      @ForAll @IntRange(min = -200, max = 200) int driftPerMillion,
      @ForAll @IntRange(min = 0, max = 60_000) int firstDelay,
      @ForAll @IntRange(min = 0, max = 60_000) int delay,
      @ForAll @IntRange(min = 0, max = 864_000_000) int between) {
    CallerClocksTest fresh = new CallerClocksTest();
    fresh.age("k1", ahead, firstDelay);
    long sent = ahead + Math.round(between * (1 + driftPerMillion * 1e-6));

    Duration age = fresh.age("k1", sent, (long) between + delay).orElseThrow();

    assertThat(age.toMillis()).isLessThanOrEqualTo(delay + 1L);
  }
}
