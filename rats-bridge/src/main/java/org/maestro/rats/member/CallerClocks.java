package org.maestro.rats.member;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.time.Clock;

/**
 * The age of calls when they arrive, from what their callers say of when they were made. A caller's
 * clock need not agree with the member's: what counts is by how much longer a call was on its way
 * than the quickest one of the same caller that was heard before. A call that is the first of its
 * caller's clock tells nothing. Clock thread only.
 */
final class CallerClocks {
  /** By which two clocks may drift apart; more than any that is kept by a quartz. */
  private static final double DRIFT = 500e-6;

  private static final int MOST_CALLERS = 64;

  private final Clock clock;
  private final Map<String, Quickest> quickest = new LinkedHashMap<>();

  CallerClocks(Clock clock) {
    this.clock = clock;
  }

  /**
   * @param difference between the member's clock at the arrival and the caller's at the sending;
   *     milliseconds of wall time
   * @param at when it arrived, by the member's clock
   */
  private record Quickest(String clock, double difference, double at) {
    double latest(double now) {
      return difference + DRIFT * Math.max(0, now - at);
    }
  }

  /**
   * Simulated time that the call was on its way at least; empty when the member cannot know.
   *
   * @param arrivedAt by the member's clock
   */
  Optional<Duration> age(Call call, Duration arrivedAt) {
    if (call.sent().isEmpty()) {
      return Optional.empty();
    }
    Call.Sent sent = call.sent().get();
    double now = arrivedAt.toMillis() / clock.speed();
    double difference = now - sent.millis();
    Optional<Quickest> before =
        Optional.ofNullable(quickest.get(call.from()))
            .filter(heard -> heard.clock().equals(sent.clock()));
    if (before.isEmpty() || difference < before.get().latest(now)) {
      note(call.from(), new Quickest(sent.clock(), difference, now));
    }
    return before.map(
        heard ->
            Duration.ofMillis(
                Math.round(Math.max(0, difference - heard.latest(now)) * clock.speed())));
  }

  private void note(String caller, Quickest call) {
    if (!quickest.containsKey(caller) && quickest.size() >= MOST_CALLERS) {
      quickest.remove(quickest.keySet().iterator().next());
    }
    quickest.put(caller, call);
  }
}
