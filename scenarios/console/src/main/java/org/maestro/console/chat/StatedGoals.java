package org.maestro.console.chat;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.bounded.BoundedMap;

/**
 * The goals that were stated in conversations, the latest of them: by whom, in which words, and
 * what has come in their way. Any thread may use it.
 */
final class StatedGoals {
  private static final int MOST = 500;

  private final Map<String, Stated> latest = BoundedMap.ofNewest(MOST);
  private final Map<String, List<String>> reasons = BoundedMap.ofNewest(MOST);
  private long turns;

  /**
   * How a goal was stated.
   *
   * @param turn number of the utterance by which it was
   */
  record Stated(String person, String words, long turn) {}

  /** The number of an utterance by which goals are stated. */
  synchronized long turn() {
    return ++turns;
  }

  synchronized void stated(String id, Stated how) {
    latest.put(id, how);
  }

  synchronized void failed(String id, List<String> why) {
    reasons.put(id, List.copyOf(why));
  }

  synchronized Optional<Stated> of(String id) {
    return Optional.ofNullable(latest.get(id));
  }

  /** Why it failed; nothing of one that did not. */
  synchronized List<String> reasons(String id) {
    return reasons.getOrDefault(id, List.of());
  }

  /** The goals of what a person said last that was a goal. */
  synchronized List<String> lastOf(String person) {
    long turn =
        latest.values().stream()
            .filter(how -> how.person().equals(person))
            .mapToLong(Stated::turn)
            .max()
            .orElse(0);
    List<String> ids = new ArrayList<>();
    latest.forEach(
        (id, how) -> {
          if (how.turn() == turn && turn > 0) {
            ids.add(id);
          }
        });
    return Collections.unmodifiableList(ids);
  }
}
