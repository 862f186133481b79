package org.maestro.knowledge;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The latest beliefs of every state variable, those that lost included. Not thread-safe. */
final class History {

  /** Beliefs kept of one variable. */
  static final int LENGTH = 16;

  private final Map<StateVariable, Deque<Past>> pasts = new LinkedHashMap<>();

  private record Past(Belief belief, long serial) {}

  /** Returns the serial of the belief that is forgotten for it, if any. */
  Optional<Long> add(StateVariable variable, Belief belief, long serial) {
    Deque<Past> past = pasts.computeIfAbsent(variable, key -> new ArrayDeque<>());
    past.addLast(new Past(belief, serial));
    return past.size() > LENGTH ? Optional.of(past.removeFirst().serial()) : Optional.empty();
  }

  /** Oldest first. */
  List<Belief> of(StateVariable variable) {
    return pasts.getOrDefault(variable, new ArrayDeque<>()).stream().map(Past::belief).toList();
  }
}
