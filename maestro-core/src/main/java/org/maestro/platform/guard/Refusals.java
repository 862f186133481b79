package org.maestro.platform.guard;

import java.util.Map;
import java.util.regex.Pattern;
import org.maestro.rats.bounded.BoundedMap;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Logs each refusal once: who is refused for the same reason again fills no disk. Thread-safe. */
final class Refusals {
  private static final Logger LOG = LoggerFactory.getLogger(Refusals.class);
  private static final int REMEMBERED = 1_000;

  /** Names in it are those that strangers give themselves. */
  private static final Pattern CONTROL = Pattern.compile("\\p{Cntrl}");

  private final Map<String, Boolean> logged = BoundedMap.ofNewest(REMEMBERED);

  synchronized void log(String sentence) {
    if (logged.putIfAbsent(sentence, true) == null) {
      LOG.warn("{}", CONTROL.matcher(sentence).replaceAll("?"));
    }
  }
}
