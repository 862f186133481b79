package org.maestro.slowest;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.platform.engine.TestExecutionResult;
import org.junit.platform.engine.support.descriptor.ClassSource;
import org.junit.platform.engine.support.descriptor.MethodSource;
import org.junit.platform.launcher.TestExecutionListener;
import org.junit.platform.launcher.TestIdentifier;
import org.junit.platform.launcher.TestPlan;

/**
 * Says at the end of the last module's tests, also when some failed, how long the build took and
 * which of its tests took longest. Of a run of a few tests it says nothing.
 */
public final class SlowestTests implements TestExecutionListener {
  private static final int FEW = 100;
  private static final int SHOWN = 10;

  private final Map<String, Instant> begun = new ConcurrentHashMap<>();
  private final List<TimedTest> ended = Collections.synchronizedList(new ArrayList<>());

  @Override
  public void executionStarted(TestIdentifier test) {
    begun.put(test.getUniqueId(), Instant.now());
  }

  @Override
  public void executionFinished(TestIdentifier test, TestExecutionResult result) {
    Instant since = begun.remove(test.getUniqueId());
    if (test.isTest() && since != null) {
      ended.add(new TimedTest(name(test), Duration.between(since, Instant.now())));
    }
  }

  @Override
  public void testPlanExecutionFinished(TestPlan plan) {
    if (ended.size() < FEW) {
      return;
    }
    Instant buildBegan = Instant.parse(System.getProperty("maestro.build.began"));
    List<TimedTest> all = new ArrayList<>(ended);
    all.addAll(SurefireReports.since(Path.of(".."), buildBegan));
    all.sort(Comparator.comparing(TimedTest::took).reversed());
    StringBuilder told =
        new StringBuilder(
            String.format(
                Locale.ROOT,
                "%nThe build has taken %d s, its %d tests %d s; some ran beside each other. The"
                    + " slowest:%n",
                Duration.between(buildBegan, Instant.now()).toSeconds(),
                all.size(),
                all.stream()
                    .map(TimedTest::took)
                    .reduce(Duration.ZERO, Duration::plus)
                    .toSeconds()));
    all.stream().limit(SHOWN).forEach(test -> told.append(test.line()).append('\n'));
    System.out.println(told);
  }

  private static String name(TestIdentifier test) {
    return test.getSource()
        .map(
            source -> {
              if (source instanceof MethodSource method) {
                return simple(method.getClassName()) + "#" + method.getMethodName();
              }
              return source instanceof ClassSource type
                  ? simple(type.getClassName()) + " " + test.getDisplayName()
                  : test.getDisplayName();
            })
        .orElse(test.getDisplayName());
  }

  static String simple(String className) {
    return className.substring(className.lastIndexOf('.') + 1);
  }
}
