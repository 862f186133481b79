package org.maestro.slowest;

import java.time.Duration;
import java.time.Instant;
import org.junit.jupiter.api.extension.AfterEachCallback;
import org.junit.jupiter.api.extension.BeforeEachCallback;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.extension.ExtensionContext.Namespace;

/**
 * Takes the time of each test of this module, and has it told with those of the modules before when
 * all have ended, also when some failed. Of a run without Maven it tells nothing.
 */
public final class SlowestTests implements BeforeEachCallback, AfterEachCallback {
  private static final Namespace OWN = Namespace.create(SlowestTests.class);
  private static final String BEGAN = "maestro.build.began";

  @Override
  public void beforeEach(ExtensionContext test) {
    test.getStore(OWN).put(BEGAN, Instant.now());
  }

  @Override
  public void afterEach(ExtensionContext test) {
    Instant since = test.getStore(OWN).get(BEGAN, Instant.class);
    String build = System.getProperty(BEGAN, "");
    if (since != null && !build.isEmpty()) {
      test.getRoot()
          .getStore(OWN)
          .getOrComputeIfAbsent(
              TimesTold.class, key -> new TimesTold(Instant.parse(build)), TimesTold.class)
          .ended(new TimedTest(name(test), Duration.between(since, Instant.now())));
    }
  }

  private static String name(ExtensionContext test) {
    String method = test.getRequiredTestMethod().getName();
    String shown = test.getDisplayName();
    return test.getRequiredTestClass().getSimpleName()
        + "#"
        + method
        + (shown.startsWith(method) ? "" : " " + shown);
  }

  static String simple(String className) {
    return className.substring(className.lastIndexOf('.') + 1);
  }
}
