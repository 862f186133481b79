package org.maestro.planning.grounding;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.Optional;
import java.util.Set;

/** A log of which facts changed from task to task, for those who looked at them some tasks ago. */
public final class ChangeLog {
  private static final int LONGEST = 256;

  private final Deque<Set<Object>> entries = new ArrayDeque<>();
  private long count;

  /** Notes what is otherwise than in the task before. */
  void add(Set<Object> changed) {
    entries.addLast(changed);
    count++;
    if (entries.size() > LONGEST) {
      entries.removeFirst();
    }
  }

  /** The number of the last entry. */
  public long last() {
    return count;
  }

  /** What became otherwise after that entry; empty when that is too long ago. */
  public Optional<Set<Object>> after(long entry) {
    if (count - entry > entries.size()) {
      return Optional.empty();
    }
    Set<Object> changed = new LinkedHashSet<>();
    entries.stream().skip(entries.size() - (count - entry)).forEach(changed::addAll);
    return Optional.of(changed);
  }
}
