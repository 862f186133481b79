package org.maestro.console.traffic;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.rats.bounded.BoundedMap;

/**
 * How soon members answer calls, in wall time: from a call on the bus to the first word on it, both
 * as they are heard here. Any thread may use it.
 */
public final class RoundTrips {
  private static final int MOST_CALLS = 1_000;
  private static final int MOST_MEMBERS = 10_000;
  private static final int LATEST = 20;

  private final Consumer<Duration> answered;

  // Both are guarded by this.
  private final Map<String, Asked> asked = BoundedMap.ofNewest(MOST_CALLS);
  private final Map<String, Deque<Duration>> byMember = BoundedMap.ofLatelyUsed(MOST_MEMBERS);

  /** A call to one member that nobody has answered yet. */
  private record Asked(String member, long atNanos) {}

  /**
   * @param answered told of each; returns at once
   */
  public RoundTrips(Consumer<Duration> answered) {
    this.answered = answered;
  }

  /**
   * @param nowNanos by {@link System#nanoTime}
   */
  public synchronized void heard(CallMessages.Said said, long nowNanos) {
    if (said.kind().equals("call")) {
      said.to().ifPresent(member -> asked.put(said.call(), new Asked(member, nowNanos)));
      return;
    }
    Asked call = asked.get(said.call());
    if (call != null && call.member().equals(said.from())) {
      asked.remove(said.call());
      Deque<Duration> latest = byMember.computeIfAbsent(said.from(), none -> new ArrayDeque<>());
      Duration after = Duration.ofNanos(nowNanos - call.atNanos());
      latest.addLast(after);
      answered.accept(after);
      if (latest.size() > LATEST) {
        latest.removeFirst();
      }
    }
  }

  /** The median of the member's latest twenty; empty before it has answered a call. */
  public synchronized Optional<Duration> median(String member) {
    List<Duration> latest =
        Optional.ofNullable(byMember.get(member)).stream().flatMap(Deque::stream).sorted().toList();
    return latest.isEmpty() ? Optional.empty() : Optional.of(latest.get(latest.size() / 2));
  }
}
