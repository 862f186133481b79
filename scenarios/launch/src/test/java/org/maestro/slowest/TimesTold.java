package org.maestro.slowest;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/** The times of a build's tests, told when JUnit closes it. Any thread may use it. */
final class TimesTold implements AutoCloseable {
  private static final int FEW = 100;
  private static final int SHOWN = 10;

  private final Instant buildBegan;
  private final List<TimedTest> ended = new ArrayList<>();

  TimesTold(Instant buildBegan) {
    this.buildBegan = buildBegan;
  }

  synchronized void ended(TimedTest test) {
    ended.add(test);
  }

  @Override
  public synchronized void close() {
    if (ended.size() >= FEW) {
      System.out.println(told());
    }
  }

  private String told() {
    List<TimedTest> all = new ArrayList<>(ended);
    all.addAll(SurefireReports.since(Path.of("../.."), buildBegan));
    all.sort(Comparator.comparing(TimedTest::took).reversed());
    Duration together = all.stream().map(TimedTest::took).reduce(Duration.ZERO, Duration::plus);
    StringBuilder told =
        new StringBuilder(
            String.format(
                Locale.ROOT,
                "%nThe build has taken %d s so far, its %d tests %d s in all; some ran beside each"
                    + " other. The slowest:%n",
                Duration.between(buildBegan, Instant.now()).toSeconds(),
                all.size(),
                together.toSeconds()));
    all.stream().limit(SHOWN).forEach(test -> told.append(test.line()).append('\n'));
    return told.toString();
  }
}
