package org.maestro.slowest;

import java.time.Duration;
import java.util.Locale;

/** A test that ended, well or not. */
record TimedTest(String name, Duration took) {
  String line() {
    return String.format(Locale.ROOT, "%8.1f s  %s", took.toMillis() / 1000.0, name);
  }
}
