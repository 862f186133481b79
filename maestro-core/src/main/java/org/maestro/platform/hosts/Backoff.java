package org.maestro.platform.hosts;

import java.time.Duration;
import java.util.Map;
import java.util.TreeMap;

/**
 * The delay before something that has died is started again: at once the first time, then twice as
 * long each time, and at once again when it has lived for long. Not thread-safe.
 */
public final class Backoff {
  private final Duration first;
  private final Duration longest;
  private final Map<String, Death> lastByName = new TreeMap<>();

  private record Death(Duration at, Duration delay) {}

  /**
   * @param first delay before the second start
   * @param longest delay, and the life after which a death is the first one again
   */
  public Backoff(Duration first, Duration longest) {
    this.first = first;
    this.longest = longest;
  }

  /**
   * It has died.
   *
   * @param now never less than before
   * @return how long it is to stay dead
   */
  public Duration died(String name, Duration now) {
    Death before = lastByName.get(name);
    Duration delay = Duration.ZERO;
    if (before != null && now.minus(before.at()).minus(before.delay()).compareTo(longest) < 0) {
      Duration doubled = before.delay().isZero() ? first : before.delay().multipliedBy(2);
      delay = doubled.compareTo(longest) > 0 ? longest : doubled;
    }
    lastByName.put(name, new Death(now, delay));
    return delay;
  }
}
