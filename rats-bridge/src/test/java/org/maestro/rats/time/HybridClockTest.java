package org.maestro.rats.time;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.junit.jupiter.api.Test;

/** Hybrid logical clocks of processes whose machines' clocks are wrong (ADE, 3.3; A43). */
class HybridClockTest {
  private static final long MOST_SKEW_MILLIS = 5_000;

  /** A process with its machine's clock, which is off by so much. */
  private static final class Process implements InstantSource {
    private final HybridClock clock = new HybridClock(this);
    private final List<HybridStamp> arriving = new ArrayList<>();
    private HybridStamp last = new HybridStamp(Long.MIN_VALUE, 0);
    private long off;
    private long time;

    @Override
    public Instant instant() {
      return Instant.ofEpochMilli(time + off);
    }

    /** What happens in a process is later than what has happened in it before. */
    private void happened(HybridStamp now) {
      assertThat(now).isGreaterThan(last);
      last = now;
    }
  }

  /** What has caused something is dated before it, and no date is farther off than the clocks. */
  @Property(tries = 300)
  void noEffectIsBeforeItsCauseAndNoTimeFartherFromTheWallThanTheClocks(
      @ForAll long seed, @ForAll @IntRange(min = 2, max = 5) int number) {
    Random random = new Random(seed);
    List<Process> processes = new ArrayList<>();
    for (int i = 0; i < number; i++) {
      processes.add(new Process());
    }
    long time = 1_000_000;
    for (int event = 0; event < 200; event++) {
      time += random.nextInt(3);
      Process here = processes.get(random.nextInt(number));
      here.time = time;
      // A clock may be set, forwards and back, at any moment.
      if (random.nextInt(10) == 0) {
        here.off = random.nextLong(-MOST_SKEW_MILLIS, MOST_SKEW_MILLIS + 1);
      }
      if (!here.arriving.isEmpty() && random.nextBoolean()) {
        HybridStamp sent = here.arriving.remove(random.nextInt(here.arriving.size()));
        HybridStamp received = here.clock.received(sent);
        assertThat(received).isGreaterThan(sent);
        here.happened(received);
      } else {
        HybridStamp now = here.clock.now();
        here.happened(now);
        if (random.nextBoolean()) {
          processes.get(random.nextInt(number)).arriving.add(now);
        }
      }
      assertThat(here.last.millis())
          .isBetween(here.instant().toEpochMilli(), time + MOST_SKEW_MILLIS);
    }
  }

  @Property
  void aStampIsReadAsItWasWritten(
      @ForAll @IntRange(min = 0) int seconds, @ForAll @IntRange(min = 0) int count) {
    HybridStamp stamp = new HybridStamp(seconds * 1_001L, count);
    assertThat(HybridStamp.read(stamp.toString())).contains(stamp);
  }

  @Test
  void whatIsNoStampIsNone() {
    for (String text :
        List.of(
            "",
            "/",
            "INFO",
            "2026-01-31T12:00:00Z",
            "2026-01-31T12:00:00Z/",
            "12:00:00.000/1",
            "2026-01-31T12:00:00Z/-1",
            "2026-01-31T12:00:00Z/99999999999")) {
      assertThat(HybridStamp.read(text)).as(text).isEqualTo(Optional.empty());
    }
  }
}
